// subtract: the chords of the round's samples, cut from the free spans of every line.
#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <vector>

#include "backends/cpu/lines.h"
#include "backends/cpu/vectors.h"
#include "base/insertion_sort.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// A line's spans in one buffer with a gap in it: the spans that are done lie below the gap, the
// rest above. Chords come in the order of y, so that the gap moves a little at a time, and each
// chord cuts where the gap is. An empty span stands at the buffer's begin and another at its end,
// so that no loop of cut() looks for the buffer's bounds. cut() writes the piece below a chord to
// done_ in any case, and moves done_ past it only if the piece is not empty; the next write
// replaces an empty one. So a typical cut has two branches.
class SpanBuffer {
public:
    // Loads the line's spans. At most `cuts` chords may be cut afterwards.
    void load(std::span<const Span> spans, std::size_t cuts) {
        const std::size_t size = spans.size() + cuts + 3;  // two sentinels and a gap to write to
        if (buffer_.size() < size) buffer_.resize(size);
        buffer_[0] = {0, 0};
        buffer_[size - 1] = {kBeyond, kBeyond};
        done_ = buffer_.data() + 1;
        end_ = buffer_.data() + size - 1;
        rest_ = end_ - spans.size();
        std::copy(spans.begin(), spans.end(), rest_);
    }

    void cut(std::span<const Span> chords) {
        Span* done = done_;
        Span* rest = rest_;
        for (const auto& [begin, end] : chords) {
            while (done[-1].end > begin) move(*--done, *--rest);
            for (; rest->end <= begin; ++rest, ++done) move(*rest, *done);
            *done = {rest->begin, begin};
            done += rest->begin < begin;
            while (rest->end <= end) ++rest;
            rest->begin = std::max(rest->begin, end);
        }
        done_ = done;
        rest_ = rest;
    }

    std::size_t count() const {
        return static_cast<std::size_t>((done_ - buffer_.data() - 1) + (end_ - rest_));
    }
    // Copies the spans to the slot, which must have room, and returns their total length.
    std::uint32_t store(std::span<Span> slot) const {
        const Span* const done = done_;
        const auto middle = std::copy(buffer_.data() + 1, done, slot.begin());
        std::copy(rest_, end_, middle);
        std::uint32_t length = 0;
        for (const Span span : slot.first(count())) length += span.end - span.begin;
        return length;
    }

private:
    static constexpr std::uint32_t kBeyond = ~std::uint32_t{0};  // above every y

    // Copies one word of 64 bits: for a struct g++ uses a string instruction, which is slow.
    static void move(const Span& from, Span& to) {
        to = std::bit_cast<Span>(std::bit_cast<std::uint64_t>(from));
    }

    std::vector<Span> buffer_;
    Span* done_ = nullptr;
    Span* rest_ = nullptr;
    Span* end_ = nullptr;
};

// A thread's memory, reused from column to column. The vectors are as long as the largest column
// needed, with the padding of vectors.h.
struct Scratch {
    std::vector<Sample> found;
    std::vector<Sample> near;
    std::vector<std::uint32_t> ends;
    std::vector<Seen> seen;
    std::vector<Span> chords;
    SpanBuffer line;

    void make_room(std::size_t samples) {
        if (found.size() >= samples + kVectorPadding) return;
        found.resize(samples + kVectorPadding);
        near.resize(samples + kVectorPadding);
        ends.resize(samples);
        seen.resize(samples + kVectorPadding);
        chords.resize(samples + 2 + kVectorPadding);  // two for the ends of a torus
    }
};

// Sorts the first `count` samples found by y: into buckets, as in sorted_bins.cpp, then by
// insertion.
std::span<const Sample> sorted(Scratch& scratch, std::uint32_t count, std::uint32_t height) {
    const std::span<const Sample> found = std::span(scratch.found).first(count);
    const std::span<Sample> near = std::span(scratch.near).first(count);
    const std::span<std::uint32_t> ends = std::span(scratch.ends).first(count);
    const auto bucket_of = [&](Sample sample) {
        return portable::bucket_of(sample.y, count, height);
    };
    std::fill(ends.begin(), ends.end(), 0);
    for (const Sample sample : found) ++ends[bucket_of(sample)];
    std::inclusive_scan(ends.begin(), ends.end(), ends.begin());
    for (const Sample sample : found) near[--ends[bucket_of(sample)]] = sample;
    insertion_sort(near, [](Sample a, Sample b) { return a.y < b.y; });
    return near;
}

// The samples that may cut a column's lines, in the order of y.
std::span<const Sample> find_near(const RoundMemory& round, std::uint32_t column,
                                  Scratch& scratch) {
    const portable::Stretch columns =
        portable::stretch_around(column, 1, round.columns, round.plan.period_x);
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < columns.count; ++k) {
        const std::uint32_t neighbour = portable::nth_of_stretch(columns, k, round.columns);
        const std::uint32_t end = round.column_begins[neighbour + 1];
        scratch.make_room(count + end - round.column_begins[neighbour]);
        for (std::uint32_t i = round.column_begins[neighbour]; i < end; ++i) {
            scratch.found[count] = {round.candidates[i].x, round.candidates[i].y};
            count += round.statuses[i] == STATUS_ADMITTED;
        }
    }
    return sorted(scratch, count, round.plan.height);
}

// The chords of a line in the order of their samples' y. All are found before the first is cut, so
// that square roots overlap and only the cuts have branches.
std::span<const Span> chords_of_line(const Plan& plan, std::uint32_t centre,
                                     std::span<const Sample> near, Scratch& scratch) {
    Span* next = scratch.chords.data();
    // On a torus, a chord that sticks out at one end is cut at the other end.
    Span bottom{0, 0};
    Span top{plan.height, plan.height};
    const auto distance_to = [&](Sample sample) {
        return portable::axis_distance(sample.x, centre, plan.period_x) + plan.chord_margin();
    };
    const auto reach_of = [&](Sample sample) {
        return portable::chord_reach(distance_to(sample), plan.radius_squared);
    };
    if (plan.period_y != 0) {
        for (std::size_t i = near.size(); i-- > 0;) {
            if (plan.height - near[i].y > plan.radius) break;
            const std::uint32_t reach = reach_of(near[i]);
            bottom.end =
                std::max(bottom.end, portable::window_end(2, near[i].y, reach, plan.height));
        }
        for (const Sample sample : near) {
            if (sample.y >= plan.radius) break;
            top.begin = std::min(
                top.begin, portable::window_begin(1, sample.y, reach_of(sample), plan.height));
        }
    }
    *next = bottom;
    next += bottom.end > 0;
    // Two samples in five are too far away from the line: they take no square root.
    std::size_t count = 0;
    for (const Sample sample : near) {
        scratch.seen[count] = {distance_to(sample), sample.y};
        count += scratch.seen[count].distance < plan.radius;
    }
    vectors_for(plan.radius)
        .find_chords(std::span(scratch.seen).first(count), plan.radius_squared, plan.height, next);
    next += count;
    *next = top;
    next += top.begin < plan.height;
    return {scratch.chords.data(), next};
}

}  // namespace

bool Lines::subtract(const RoundMemory& round, std::uint32_t column,
                     std::vector<std::uint32_t>& free_lengths) {
    // Looked up once: in a shared library, such as Python's module, each use of a thread_local is a
    // call.
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;
    const std::span<const Sample> near = find_near(round, column, scratch);
    if (near.empty()) return true;

    bool complete = true;
    const Span own = plan_.own_lines();
    const std::uint32_t end = std::min(first_lines_[column + 1], own.end);
    for (std::uint32_t i = std::max(first_lines_[column], own.begin); i < end; ++i) {
        if (span_counts_[i] == 0) continue;
        const std::span<const Span> chords =
            chords_of_line(plan_, plan_.centre_of_line(i), near, scratch);
        SpanBuffer& line = scratch.line;
        line.load(spans_of(i), chords.size());
        line.cut(chords);
        if (line.count() > capacity_) {
            complete = false;
            continue;
        }
        span_counts_[i] = static_cast<std::uint32_t>(line.count());
        free_lengths[i] = line.store({slot(i), capacity_});
    }
    return complete;
}

}  // namespace lacuna::cpu

// subtract: the chords of the round's samples, cut from the free spans of every line.
#include <algorithm>
#include <numeric>

#include "backends/cpu/state.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// A line's spans in one buffer with a gap in it: the spans that are done lie below the gap, the
// rest above. Chords come in the order of y, so that the gap moves a little at a time, and each
// chord cuts where the gap is. An empty span stands at the buffer's begin and another at its end,
// so that no loop of cut() looks for the buffer's bounds. cut() writes the piece below a chord to
// done_ in any case, and moves done_ past it only if the piece is not empty; the next write
// replaces an empty one. So a typical cut has two branches.
class Line {
public:
    // Loads the line's spans; so many cuts may follow.
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

    // Takes [begin, end) out.
    void cut(std::uint32_t begin, std::uint32_t end) {
        while (done_[-1].end > begin) *--rest_ = *--done_;
        while (rest_->end <= begin) *done_++ = *rest_++;
        *done_ = {rest_->begin, begin};
        done_ += rest_->begin < begin;
        while (rest_->end <= end) ++rest_;
        rest_->begin = std::max(rest_->begin, end);
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

    std::vector<Span> buffer_;
    Span* done_ = nullptr;
    Span* rest_ = nullptr;
    Span* end_ = nullptr;
};

struct Scratch {
    std::vector<Sample> near;
    std::vector<Sample> unsorted;
    std::vector<std::uint32_t> ends;
    std::vector<Span> chords;
    Line line;
};

// Sorts what is near by y: by buckets, as a column's candidates, then among neighbours.
void sort_near(Scratch& scratch, std::uint32_t height) {
    auto& [near, unsorted, ends, chords, line] = scratch;
    const auto count = static_cast<std::uint32_t>(near.size());
    const auto bucket_of = [&](Sample sample) {
        return portable::bucket_of(sample.y, count, height);
    };
    ends.assign(count, 0);
    for (const Sample sample : near) ++ends[bucket_of(sample)];
    std::inclusive_scan(ends.begin(), ends.end(), ends.begin());
    unsorted.swap(near);
    near.resize(count);
    for (const Sample sample : unsorted) near[--ends[bucket_of(sample)]] = sample;
    for (std::size_t i = 1; i < near.size(); ++i) {
        const Sample moved = near[i];
        std::size_t to = i;
        for (; to > 0 && moved.y < near[to - 1].y; --to) near[to] = near[to - 1];
        near[to] = moved;
    }
}

// The samples that may cut a column's lines, in the order of y.
void gather(const SpanState& state, std::uint32_t column, Scratch& scratch) {
    std::vector<Sample>& near = scratch.near;
    const portable::Stretch columns =
        portable::stretch_around(column, 1, state.columns, state.plan.period_x);
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < columns.count; ++k) {
        const std::uint32_t neighbour = portable::nth_of_stretch(columns, k, state.columns);
        const std::uint32_t end = state.column_begins[neighbour + 1];
        near.resize(count + end - state.column_begins[neighbour]);
        for (std::uint32_t i = state.column_begins[neighbour]; i < end; ++i) {
            near[count] = {state.candidates[i].x, state.candidates[i].y};
            count += state.fates[i] == FATE_ADMITTED;
        }
        near.resize(count);
    }
    sort_near(scratch, state.plan.height);
}

// The chords of a line in the order of their samples' y, all found before the first is cut: the
// square roots then overlap, and the cuts are what remains to be predicted.
void find_chords(const Plan& plan, std::uint32_t centre, std::span<const Sample> near,
                 std::vector<Span>& chords) {
    chords.resize(near.size() + 2);  // and one for each end of a torus
    Span* next = chords.data();
    // On a torus, what sticks out at one end is cut at the other.
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
    // Two samples in five are too far away: they are left out before any root is taken. Until its
    // chord is known, an entry holds the sample's distance and y.
    Span* const first = next;
    for (const Sample sample : near) {
        *next = {distance_to(sample), sample.y};
        next += next->begin < plan.radius;
    }
    const Span* const end = next;
    next = first;
    for (const Span* entry = first; entry != end; ++entry) {
        const std::uint32_t y = entry->end;
        const std::uint32_t reach = portable::chord_reach(entry->begin, plan.radius_squared);
        *next = {portable::window_begin(0, y, reach, plan.height),
                 portable::window_end(0, y, reach, plan.height)};
        next += reach > 0;
    }
    *next = top;
    next += top.begin < plan.height;
    chords.resize(static_cast<std::size_t>(next - chords.data()));
}

}  // namespace

bool subtract(SpanState& state, std::uint32_t column) {
    // Looked up once: in a shared library, as Python's, each look at a thread's own takes a call.
    thread_local Scratch of_thread;
    Scratch& scratch = of_thread;
    auto& [near, unsorted, ends, chords, line] = scratch;
    gather(state, column, scratch);
    if (near.empty()) return true;

    bool complete = true;
    for (std::uint32_t i = state.first_lines[column]; i < state.first_lines[column + 1]; ++i) {
        if (state.span_counts[i] == 0) continue;
        find_chords(state.plan, state.plan.centre_of_line(i), near, chords);
        line.load(state.slot(i).first(state.span_counts[i]), chords.size());
        for (const Span chord : chords) line.cut(chord.begin, chord.end);
        if (line.count() > state.capacity) {
            complete = false;
            continue;
        }
        state.span_counts[i] = static_cast<std::uint32_t>(line.count());
        state.free_lengths[i] = line.store(state.slot(i));
    }
    return complete;
}

}  // namespace lacuna::cpu

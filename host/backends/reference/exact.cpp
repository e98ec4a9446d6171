// Mode exact, written to be read: places that hold all of the free space, candidates that count
// only where they are truly free, and ever finer places until none is left (DESIGN section 4).
#include "backends/reference/exact.h"

#include <algorithm>

#include "backends/reference/free_space.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "rounds/random.h"
#include "rounds/round_policy.h"

namespace lacuna::reference {
namespace {

// All samples, in square bins at least a radius wide, so that what is near a point lies in its own
// bin or in one beside it.
class Samples {
public:
    explicit Samples(const Plan& plan)
        : plan_(plan),
          columns_(std::max(1u, plan.width / plan.radius)),
          rows_(std::max(1u, plan.height / plan.radius)),
          bins_(std::size_t{columns_} * rows_) {}

    void add(Sample sample) { bin(column_of(sample.x), row_of(sample.y)).push_back(sample); }

    bool is_free(Sample place) const {
        bool is_free = true;
        for_each_near(place.x, place.y, [&](Sample sample) {
            if (portable::conflicts(sample.x, sample.y, place.x, place.y, plan_.period_x,
                                    plan_.period_y, plan_.radius_squared))
                is_free = false;
        });
        return is_free;
    }

    // All samples within two radii of (x, y), and others. On a small torus some more than once.
    template <typename Visit>
    void for_each_near(std::uint32_t x, std::uint32_t y, Visit visit) const {
        for (std::int64_t i = -2; i <= 2; ++i) {
            for (std::int64_t j = -2; j <= 2; ++j) {
                const auto column = shifted(column_of(x), i, columns_, plan_.period_x != 0);
                const auto row = shifted(row_of(y), j, rows_, plan_.period_y != 0);
                if (column < 0 || row < 0) continue;
                const auto index = static_cast<std::size_t>(column * rows_ + row);
                for (const Sample sample : bins_[index]) visit(sample);
            }
        }
    }

private:
    std::uint32_t column_of(std::uint32_t x) const {
        return static_cast<std::uint32_t>(std::uint64_t{x} * columns_ / plan_.width);
    }
    std::uint32_t row_of(std::uint32_t y) const {
        return static_cast<std::uint32_t>(std::uint64_t{y} * rows_ / plan_.height);
    }
    std::vector<Sample>& bin(std::uint32_t column, std::uint32_t row) {
        return bins_[std::size_t{column} * rows_ + row];
    }
    // -1 where a box has nothing.
    static std::int64_t shifted(std::int64_t index, std::int64_t by, std::int64_t count,
                                bool wraps) {
        const std::int64_t there = index + by;
        if (wraps) return (there % count + count) % count;
        return there < count ? there : -1;
    }

    const Plan& plan_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<std::vector<Sample>> bins_;
};

// What is left of a strip of the box after all samples' chords are cut from it. A chord covers the
// strip's whole width: it is cut at the far edge.
void append_remnants(const Plan& plan, const Samples& samples, Box strip, std::uint32_t width,
                     std::vector<Box>& remnants) {
    std::vector<Span> chords;
    const std::uint32_t centre = strip.x + width / 2;
    samples.for_each_near(centre, strip.begin, [&](Sample sample) {
        const std::uint32_t dx = portable::axis_distance(sample.x, centre, plan.period_x);
        const std::uint32_t reach = portable::chord_reach(dx + width / 2, plan.radius_squared);
        if (reach == 0) return;
        const std::uint32_t height = plan.height;
        chords.push_back(
            {portable::chord_begin(sample.y, reach), portable::chord_end(sample.y, reach, height)});
        if (plan.period_y == 0) return;
        chords.push_back({0, portable::chord_wrapped_end(sample.y, reach, height)});
        chords.push_back({portable::chord_wrapped_begin(sample.y, reach, height), height});
    });
    std::sort(chords.begin(), chords.end(), [](Span a, Span b) { return a.begin < b.begin; });

    std::uint32_t free_from = strip.begin;
    for (const Span chord : chords) {
        const std::uint32_t free_to = std::min(chord.begin, strip.end);
        if (free_from < free_to) remnants.push_back({strip.x, free_from, free_to});
        free_from = std::max(free_from, chord.end);
    }
    if (free_from < strip.end) remnants.push_back({strip.x, free_from, strip.end});
}

// The places: lines with free spans at first, boxes after the first refinement.
struct Places {
    explicit Places(const Plan& the_plan)
        : plan(the_plan), width(plan.strip_width), lines(the_plan) {}

    const Plan& plan;
    std::uint32_t width;
    FreeSpace lines;
    std::vector<Box> boxes;
    bool are_boxes = false;

    std::uint32_t count() const {
        return are_boxes ? static_cast<std::uint32_t>(boxes.size()) : plan.lines;
    }
    std::uint32_t free_length(std::uint32_t place) const {
        return are_boxes ? boxes[place].end - boxes[place].begin : lines.free_length(place);
    }
    Sample at(std::uint32_t place, std::uint32_t rank, std::uint32_t offset) const {
        if (are_boxes) return {boxes[place].x + offset, boxes[place].begin + rank};
        return {place * plan.strip_width + offset, lines.y_at_rank(place, rank)};
    }
    // F_X, over the places.
    std::vector<std::uint64_t> cdf() const {
        std::vector<std::uint64_t> sums(count());
        std::uint64_t sum = 0;
        for (std::uint32_t place = 0; place < count(); ++place)
            sums[place] = sum += free_length(place);
        return sums;
    }

    // Free spans, as boxes that end where a row of cells does.
    std::vector<Box> boxes_of_lines() const {
        std::vector<Box> all;
        for (std::uint32_t line = 0; line < plan.lines; ++line) {
            for (const Span span : lines.spans(line)) {
                for (std::uint32_t begin = span.begin; begin < span.end;) {
                    const std::uint32_t row_end = begin - begin % plan.grid_side + plan.grid_side;
                    const std::uint32_t end = std::min(span.end, row_end);
                    all.push_back({line * plan.strip_width, begin, end});
                    begin = end;
                }
            }
        }
        return all;
    }

    void refine(const Samples& samples, bool halve) {
        const std::vector<Box> old = are_boxes ? std::move(boxes) : boxes_of_lines();
        const std::uint32_t new_width = halve ? width / 2 : width;
        boxes.clear();
        for (const Box box : old)
            for (std::uint32_t x = box.x; x < box.x + width; x += new_width)
                append_remnants(plan, samples, {x, box.begin, box.end}, new_width, boxes);
        width = new_width;
        are_boxes = true;
    }
};

Sample draw(const Plan& plan, const Places& places, const std::vector<std::uint64_t>& cdf,
            std::uint64_t number) {
    const RandomBits random = random_bits(plan.seed, number);
    const std::uint64_t c = scaled(random.first, cdf.back());
    const auto place =
        static_cast<std::uint32_t>(std::upper_bound(cdf.begin(), cdf.end(), c) - cdf.begin());
    const std::uint64_t rank = c - (place == 0 ? 0 : cdf[place - 1]);
    return places.at(place, static_cast<std::uint32_t>(rank),
                     static_cast<std::uint32_t>(scaled(random.second, places.width)));
}

}  // namespace

Outcome sample_exact(const Plan& plan, Observer& observer) {
    Outcome outcome;
    Places places(plan);
    Samples samples(plan);
    RoundPolicy policy(plan);

    while (outcome.samples.size() < plan.limit) {
        const std::vector<std::uint64_t> cdf = places.cdf();
        if (cdf.empty() || cdf.back() == 0) break;  // every point is covered: the set is maximal

        // Survivors are what the samples of earlier rounds leave of the draws.
        const std::size_t first = outcome.samples.size();
        std::vector<std::pair<Sample, std::uint64_t>> survivors;
        for (std::uint64_t i = 0; i < policy.size(); ++i) {
            const std::uint64_t number = outcome.draws++;
            const Sample candidate = draw(plan, places, cdf, number);
            if (samples.is_free(candidate)) survivors.emplace_back(candidate, number);
        }
        for (const auto& [candidate, number] : survivors) {
            if (!samples.is_free(candidate)) continue;
            samples.add(candidate);
            outcome.samples.push_back(candidate);
            outcome.numbers.push_back(number);
        }
        const std::uint64_t points = outcome.samples.size();
        if (policy.refines())
            places.refine(samples, policy.halves());
        else
            for (std::size_t i = first; i < points; ++i)
                places.lines.subtract_disk(outcome.samples[i]);

        outcome.rounds++;
        if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
            throw Cancelled();
        policy.note(survivors.size(), points - first, places.count(), places.width);
    }
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

}  // namespace lacuna::reference

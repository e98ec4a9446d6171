// subtract in mode cells: the lattice points that the round's samples block, taken out of every
// line by the two-way check of section 4.2, a pixel's run of points at a time.
#include <algorithm>
#include <bit>

#include "backends/cpu/state.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/metric.h"

namespace lacuna::cpu {
namespace {

// Clears the bits [begin, end), and returns how many were set.
std::uint32_t clear(std::span<std::uint64_t> line, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t cleared = 0;
    const std::uint32_t last = (end - 1) / 64;
    for (std::uint32_t word = begin / 64; word <= last; ++word) {
        if (line[word] == 0) continue;
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == begin / 64) mask &= ~std::uint64_t{0} << (begin % 64);
        if (word == last) mask &= ~std::uint64_t{0} >> (63 - (end - 1) % 64);
        cleared += static_cast<std::uint32_t>(std::popcount(line[word] & mask));
        line[word] &= ~mask;
    }
    return cleared;
}

// Shrinks [begin, end) to its first and last set bit; to nothing if there is none.
void shrink(std::span<const std::uint64_t> line, std::uint32_t& begin, std::uint32_t& end) {
    std::uint32_t word = begin / 64;
    std::uint64_t bits = line[word] & ~std::uint64_t{0} << (begin % 64);
    while (bits == 0) {
        if (++word > (end - 1) / 64) {
            end = begin;
            return;
        }
        bits = line[word];
    }
    begin = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
    if (begin >= end) {
        end = begin;
        return;
    }
    word = (end - 1) / 64;
    bits = line[word] & ~std::uint64_t{0} >> (63 - (end - 1) % 64);
    while (bits == 0) bits = line[--word];
    end = word * 64 + 64 - static_cast<std::uint32_t>(std::countl_zero(bits));
}

// One sample on one line.
class Cut {
public:
    Cut(const BitState& state, const Candidate& sample, std::uint32_t radius, std::uint32_t x)
        : state_(state),
          radius_(radius),
          line_(state.line(x)),
          pixels_(&state.radii.radii[std::size_t{state.radii.column_of[x]} * state.radii.rows]),
          dx_(portable::axis_distance(sample.x, x, state.plan.period_x)) {}

    // Blocks what the sample, seen at height y, takes of [low, high).
    void block(std::int64_t y, std::int64_t low, std::int64_t high) {
        low = std::max<std::int64_t>(low, 0);
        high = std::min<std::int64_t>(high, state_.plan.height);
        if (low >= high) return;
        auto begin = static_cast<std::uint32_t>(low);
        auto end = static_cast<std::uint32_t>(high);
        shrink(line_, begin, end);
        const RadiusMap& radii = state_.radii;
        std::uint32_t from = begin;  // [from, begin) is blocked, but not yet cleared
        while (begin < end) {
            const std::uint32_t row = radii.row_of[begin];
            const std::uint32_t run_end = std::min(end, radii.row_begins[row + 1]);
            const auto [run_from, run_to] = blocked_of_run(pixels_[row], y, begin, run_end);
            if (run_from != begin) {
                flush(from, begin);
                from = run_from;
            }
            if (run_to != run_end) {
                flush(from, run_to);
                from = run_end;
            }
            begin = run_end;
        }
        flush(from, end);
    }
    std::uint32_t blocked() const { return blocked_; }

private:
    struct Stretch {
        std::uint32_t from;
        std::uint32_t to;
    };

    // What the metric of the sample and such a pixel takes of [begin, end), above which lies that
    // pixel alone. Mostly all or nothing, which squared distances tell without a root.
    Stretch blocked_of_run(std::uint32_t pixel, std::int64_t y, std::uint32_t begin,
                           std::uint32_t end) {
        if (pixel == 0) return {begin, end};  // no importance: never set
        const std::uint64_t limit = limit_to(pixel);
        const std::int64_t below = y - begin;                  // of the run's first point
        const std::int64_t above = std::int64_t{end} - 1 - y;  // of its last
        if (is_blocked(std::max(below, above), limit)) return {begin, end};
        const std::int64_t nearest = std::max<std::int64_t>({-below, -above, 0});
        if (!is_blocked(nearest, limit)) return {end, end};
        const std::int64_t reach = portable::chord_reach(dx_, limit);
        return {static_cast<std::uint32_t>(std::max<std::int64_t>(begin, y - reach + 1)),
                static_cast<std::uint32_t>(std::min<std::int64_t>(end, y + reach))};
    }

    bool is_blocked(std::int64_t dy, std::uint64_t limit) const {
        const auto distance = static_cast<std::uint64_t>(dy);
        return std::uint64_t{dx_} * dx_ + distance * distance < limit;
    }

    std::uint64_t limit_to(std::uint32_t pixel) const {
        return portable::metric_squared(portable::twice_metric_radius(
            static_cast<std::uint32_t>(state_.plan.metric), radius_, pixel));
    }

    void flush(std::uint32_t from, std::uint32_t to) {
        if (from < to) blocked_ += clear(line_, from, to);
    }

    const BitState& state_;
    std::uint32_t radius_;
    std::span<std::uint64_t> line_;
    const std::uint32_t* pixels_;
    std::uint32_t dx_;
    std::uint32_t blocked_ = 0;
};

bool any_set(std::span<const std::uint64_t> line, std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return false;
    shrink(line, begin, end);
    return begin < end;
}

// How far from the sample's height a free point of line x can be that it blocks, plus 1; 0 if none.
// With min no farther than its radius. With mean and max the widest pixels reach farthest, and they
// are the first to be blocked.
std::int64_t half_chord(BitState& state, std::uint32_t reach, std::uint32_t radius,
                        std::uint32_t dx, std::uint32_t x) {
    const RadiusMap& radii = state.radii;
    std::uint64_t limit = std::uint64_t{reach} * reach + 1;
    const std::uint64_t dx_squared = std::uint64_t{dx} * dx;
    if (dx_squared >= limit) return 0;
    const auto metric = static_cast<std::uint32_t>(state.plan.metric);
    if (!portable::is_far_reach(metric, reach, radius)) return portable::chord_reach(dx, limit);

    // Pass over pixels without a free point until one has some, or all that are left are too small.
    const std::size_t pixels = std::size_t{radii.column_of[x]} * radii.rows;
    for (std::uint32_t& i = state.widest[x]; i < radii.rows; ++i) {
        const std::uint32_t row = radii.widest_rows[pixels + i];
        const std::uint32_t bound = portable::class_bound(radii.radii[pixels + row]);
        limit = std::min(
            limit, portable::metric_squared(portable::twice_metric_radius(metric, radius, bound)));
        if (dx_squared >= limit) return 0;
        if (any_set(state.line(x), radii.row_begins[row], radii.row_begins[row + 1]))
            return portable::chord_reach(dx, limit);
    }
    return 0;
}

}  // namespace

void subtract(BitState& state, std::uint32_t column) {
    const Plan& plan = state.plan;
    for (std::uint32_t k = state.near_begins[column]; k < state.near_begins[column + 1]; ++k) {
        const Candidate& sample = state.candidates[state.near[k]];
        const std::uint32_t reach = state.reach_of(sample);
        const std::uint32_t radius = state.candidate_radii[state.near[k]];
        for (std::uint32_t x = state.first_lines[column]; x < state.first_lines[column + 1]; ++x) {
            const std::uint32_t dx = portable::axis_distance(sample.x, x, plan.period_x);
            const std::int64_t half = half_chord(state, reach, radius, dx, x);
            if (half == 0) continue;
            Cut cut(state, sample, radius, x);
            const std::int64_t y = sample.y;
            cut.block(y, y - half + 1, y + half);
            for (const std::int64_t shift :
                 {-std::int64_t{plan.period_y}, std::int64_t{plan.period_y}})
                if (shift != 0) cut.block(y + shift, y + shift - half + 1, y + shift + half);
            state.free_lengths[x] -= cut.blocked();
        }
    }
}

}  // namespace lacuna::cpu

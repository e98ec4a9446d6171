// subtract in mode cells: clears the lattice points that the round's samples block, by the two-way
// check of section 4.2. The points of a line are served in runs that lie under one pixel.
#include <algorithm>
#include <bit>

#include "backends/cpu/lattice.h"
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

// Shrinks [begin, end) to its first and last set bit, or to nothing if there is none.
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

// Blocks the points of one line that conflict with one sample.
class PointBlocker {
public:
    PointBlocker(const Lattice& lattice, std::uint32_t radius, std::uint32_t dx, std::uint32_t x)
        : lattice_(lattice),
          radius_(radius),
          line_(lattice.line(x)),
          pixels_(
              &lattice.radii.radii[std::size_t{lattice.radii.column_of[x]} * lattice.radii.rows]),
          dx_(dx) {}

    // Blocks the points in [begin, end) that conflict with a sample at height y, as if they lay
    // `shift` higher, which serves the line's other end on a torus.
    void block(std::uint32_t y, std::uint32_t begin, std::uint32_t end, std::uint32_t shift) {
        if (begin >= end) return;
        shrink(line_, begin, end);
        const RadiusMap& radii = lattice_.radii;
        std::uint32_t from = begin;  // [from, begin) is blocked, but not yet cleared
        while (begin < end) {
            const std::uint32_t row = radii.row_of[begin];
            const std::uint32_t run_end = std::min(end, radii.row_begins[row + 1]);
            const Span run = blocked_of_run(pixels_[row], y, {begin + shift, run_end + shift});
            if (run.begin - shift != begin) {
                flush(from, begin);
                from = run.begin - shift;
            }
            if (run.end - shift != run_end) {
                flush(from, run.end - shift);
                from = run_end;
            }
            begin = run_end;
        }
        flush(from, end);
    }
    std::uint32_t blocked() const { return blocked_; }

private:
    // The part of the run that conflicts with the sample; the run lies under this pixel. Mostly it
    // is all or nothing, which squared distances show without a square root.
    Span blocked_of_run(std::uint32_t pixel, std::uint32_t y, Span run) const {
        if (pixel == 0) return run;  // no importance: its bits are never set
        const std::uint64_t limit = portable::metric_squared(
            portable::twice_metric_radius(lattice_.metric(), radius_, pixel));
        if (portable::squared_length(dx_, portable::farthest_distance(y, run.begin, run.end)) <
            limit)
            return run;
        if (portable::squared_length(dx_, portable::nearest_distance(y, run.begin, run.end)) >=
            limit)
            return {run.end, run.end};
        const std::uint32_t reach = portable::chord_reach(dx_, limit);
        return {std::max(run.begin, y >= reach ? y - reach + 1 : 0), std::min(run.end, y + reach)};
    }

    void flush(std::uint32_t from, std::uint32_t to) {
        if (from < to) blocked_ += clear(line_, from, to);
    }

    const Lattice& lattice_;
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

// 1 more than the largest distance in y of a free point of line x that the sample may block; 0 if
// there is none. With min the radius bounds it. With mean and max the pixels of largest radius are
// blocked from farthest away, and first have no free point.
std::uint32_t half_chord(const Lattice& lattice, std::uint32_t& widest, std::uint32_t reach,
                         std::uint32_t radius, std::uint32_t dx, std::uint32_t x) {
    const RadiusMap& radii = lattice.radii;
    std::uint64_t limit = portable::squared_length(reach, 0) + 1;
    const std::uint64_t dx_squared = portable::squared_length(dx, 0);
    if (dx_squared >= limit) return 0;
    if (!portable::is_far_reach(lattice.metric(), reach, radius))
        return portable::chord_reach(dx, limit);

    // Skip pixels without a free point until one has some, or all the others are too small.
    const std::size_t pixels = std::size_t{radii.column_of[x]} * radii.rows;
    for (; widest < radii.rows; ++widest) {
        const std::uint32_t row = radii.widest_rows[pixels + widest];
        const std::uint32_t bound = portable::class_bound(radii.radii[pixels + row]);
        limit = std::min(limit, portable::metric_squared(portable::twice_metric_radius(
                                    lattice.metric(), radius, bound)));
        if (dx_squared >= limit) return 0;
        if (any_set(lattice.line(x), radii.row_begins[row], radii.row_begins[row + 1]))
            return portable::chord_reach(dx, limit);
    }
    return 0;
}

}  // namespace

void Lattice::subtract() {
    find_near();
    for_columns(near_.size(), [&](std::uint32_t column) { subtract(column); });
}

void Lattice::subtract(std::uint32_t column) {
    const Plan& plan = round.plan;
    const std::uint32_t first = begins[column], end = begins[column + 1];
    for (std::uint32_t k = near_begins_[column]; k < near_begins_[column + 1]; ++k) {
        const Candidate& sample = round.candidates[near_[k]];
        const std::uint32_t reach = reach_of(sample);
        const std::uint32_t radius = candidate_radii[near_[k]];
        for (std::uint32_t x = first; x < end; ++x) {
            const std::uint32_t dx = portable::axis_distance(sample.x, x, plan.period_x);
            const std::uint32_t half = half_chord(*this, widest_[x], reach, radius, dx, x);
            if (half == 0) continue;
            PointBlocker blocker(*this, radius, dx, x);
            const std::uint32_t y = sample.y;
            const std::uint32_t height = plan.height;
            blocker.block(y, portable::window_begin(0, y, half, height),
                          portable::window_end(0, y, half, height), 0);
            if (plan.period_y != 0) {
                blocker.block(y, 0, portable::window_end(2, y, half, height), height);
                blocker.block(y + height, portable::window_begin(1, y, half, height), height, 0);
            }
            free_lengths[x] -= blocker.blocked();
        }
    }
}

}  // namespace lacuna::cpu

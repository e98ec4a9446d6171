// The rule of samples with one radius, which the sample grid finds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "backends/cpu/box_cutter.h"
#include "backends/cpu/sample_grid.h"
#include "portable/distance.h"

namespace lacuna::cpu {

class OneRadius {
public:
    using Active = Box;
    // Room for the samples near a box. A box and a radius around it reach over at most 7 x 6 cells,
    // where cells at the edge of a torus may count twice.
    static constexpr std::size_t kMostNear = 64;
    static constexpr bool kIsBatched = false;
    static constexpr std::size_t kAhead = 4;  // prefetch distance; 4 to 8 are equally fast

    OneRadius(const SampleGrid& grid, bool halve)
        : grid_(grid), plan_(grid.plan()), halve_(halve ? 1 : 0), own_(plan_.own_x()) {}
    const Plan& plan() const { return plan_; }

    std::size_t group_size(std::span<const Box>) const { return 1; }
    void fetch(const Box& later) const { grid_.fetch_near(later.x, later.begin); }
    // A box in the halo stays as it is.
    bool begin(const Box& box) const { return box.x - own_.begin < own_.end - own_.begin; }
    std::size_t find_near(std::span<const Box> boxes) {
        const Box& box = boxes.front();
        near_count_ = 0;
        // Every cell is written, but only samples raise the count, so that there is no branch.
        grid_.for_each_cell_near(box.x, box.x + box.width, box.begin, box.end, [&](Sample cell) {
            near_[near_count_] = cell;
            near_count_ += cell.x != NO_SAMPLE;
        });
        return 1;
    }
    void end(bool) const {}
    std::size_t near_count() const { return near_count_; }

    template <typename Visit>
    void for_each_part(const Box& box, Visit visit) const {
        const std::uint32_t width = box.width >> halve_;
        for (std::uint32_t x = box.x; x < box.x + box.width; x += width)
            visit(Box{x, width, box.begin, box.end});
    }
    static Box active(const Box& box) { return box; }

    bool wraps(const Box& box) const {
        return plan_.period_y != 0 &&
               (box.begin < plan_.radius || box.end + plan_.radius > plan_.height);
    }
    // Most samples near a box do not touch it. Squared distances show that, so that square roots
    // are taken for the rest only.
    bool find_touching(const Box& box, Touching& touching) const {
        bool is_covered = false;
        touching.find(0, near_count_, [&](std::size_t k) -> bool {
            const std::uint32_t dx = distance_to(near_[k], box);
            const auto is_within = [&](std::uint32_t dy) {
                return portable::squared_length(dx, dy) < plan_.radius_squared;
            };
            const std::uint32_t y = near_[k].y;
            is_covered |= is_within(portable::farthest_distance(y, box.begin, box.end));
            return is_within(portable::nearest_distance(y, box.begin, box.end));
        });
        return is_covered;
    }
    portable::Interval chord(std::size_t k, std::size_t, const Box& box) const {
        return disk_chord(near_[k], plan_.radius_squared, box, plan_.period_x);
    }

private:
    // The distance in x to the far edge of the box.
    std::uint32_t distance_to(Sample sample, const Box& box) const {
        const std::uint32_t half = box.width / 2;
        return portable::axis_distance(sample.x, box.x + half, plan_.period_x) + half;
    }

    const SampleGrid& grid_;
    const Plan& plan_;
    std::uint32_t halve_;
    Span own_;  // the interval of x outside the halo
    std::array<Sample, kMostNear> near_;
    std::size_t near_count_ = 0;
};

}  // namespace lacuna::cpu

// Finds whether a sample near a border covers a position.
#pragma once

#include <cstdint>
#include <span>

#include "backends/cpu/sample_grid.h"
#include "plan/plan.h"

namespace lacuna {

// A grid of the plan's samples whose x lies in an interval.
class BorderGrid {
public:
    BorderGrid(const Plan& plan, Span x) : x_(x), plan_(plan_of(plan, x)), grid_(plan_) {
        grid_.clear(0, 1);
    }
    BorderGrid(const BorderGrid&) = delete;
    BorderGrid& operator=(const BorderGrid&) = delete;

    bool holds(std::uint32_t x) const { return x >= x_.begin && x < x_.end; }
    // Inserts the samples whose x lies in the interval.
    void insert(std::span<const Sample> samples) {
        for (const Sample sample : samples)
            if (holds(sample.x)) grid_.insert({sample.x - x_.begin, sample.y});
    }
    // Whether one of these samples is closer than the radius.
    bool is_covered(std::uint32_t x, std::uint32_t y) const {
        return grid_.is_covered(x - x_.begin, y);
    }

private:
    static Plan plan_of(const Plan& plan, Span x) {
        Plan part = plan;
        part.width = x.end - x.begin;
        part.grid_columns = (part.width - 1) / part.grid_side + 1;
        return part;
    }

    Span x_;
    Plan plan_;
    cpu::SampleGrid grid_;
};

}  // namespace lacuna

// Finds whether a sample near a border covers a position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plan/make_plan.h"
#include "plan/plan.h"
#include "portable/distance.h"
#include "portable/status.h"
#include "portable/stretch.h"

namespace lacuna {

// A grid of the plan's samples whose x lies in an interval.
class BorderGrid {
public:
    BorderGrid(const Plan& plan, Span x)
        : plan_(plan),
          x_(x),
          shape_(grid_of(x.end - x.begin, plan.height, plan.radius)),
          cells_(std::size_t{shape_.columns} * shape_.rows, Sample{NO_SAMPLE, NO_SAMPLE}) {}

    bool holds(std::uint32_t x) const { return x >= x_.begin && x < x_.end; }
    // Inserts the samples whose x lies in the interval.
    void insert(std::span<const Sample> samples) {
        for (const Sample sample : samples)
            if (holds(sample.x))
                cells_[cell((sample.x - x_.begin) / shape_.side, sample.y / shape_.side)] = sample;
    }
    // Whether one of these samples is closer than the radius.
    bool is_covered(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t at = x - x_.begin;
        const portable::Stretch columns = portable::cells_near(
            at, at + 1, plan_.radius, x_.end - x_.begin, 0, shape_.side, shape_.columns);
        const portable::Stretch rows = portable::cells_near(
            y, y + 1, plan_.radius, plan_.height, plan_.period_y, shape_.side, shape_.rows);
        for (std::uint32_t i = 0; i < columns.count; ++i)
            for (std::uint32_t j = 0; j < rows.count; ++j) {
                const Sample near =
                    cells_[cell(columns.first + i, portable::nth_of_stretch(rows, j, shape_.rows))];
                if (near.x != NO_SAMPLE &&
                    portable::are_closer(near.x, near.y, x, y, 0, plan_.period_y,
                                         plan_.radius_squared))
                    return true;
            }
        return false;
    }

private:
    std::size_t cell(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{column} * shape_.rows + row;
    }

    const Plan& plan_;
    Span x_;
    GridShape shape_;
    std::vector<Sample> cells_;
};

}  // namespace lacuna

// The columns that may hold a conflict with a candidate of mode cells.
#pragma once

#include <algorithm>
#include <cstdint>

#include "backends/cpu/lattice.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/metric.h"

namespace lacuna::cpu {

// A candidate's point and radius, and the columns within its reach.
class ColumnsInReach {
public:
    ColumnsInReach(const Lattice& lattice, const Candidate& at, std::uint32_t radius,
                   const WidestRadii& widest)
        : lattice_(lattice),
          x_(at.x),
          radius_(radius),
          reach_(lattice.reach_of(at)),
          widest_(widest) {
        columns_ = portable::columns_of_stretch(
            portable::stretch_around(x_, reach_, lattice.round.plan.lines,
                                     lattice.round.plan.period_x),
            lattice.round.plan.lines, lattice.round.columns);
        is_far_ = columns_.count >= 2 * WidestRadii::kBlock ||
                  portable::is_far_reach(lattice_.metric(), reach_, radius);
    }

    // Calls visit(column, reach) for the columns within reach until it returns true; returns
    // whether it did. Skips columns whose radii are all too small for a conflict.
    template <typename Visit>
    bool any(Visit visit) const {
        for (std::uint32_t k = 0; k < columns_.count; ++k) {
            const std::uint32_t column =
                portable::nth_of_stretch(columns_, k, lattice_.round.columns);
            std::uint32_t reach = reach_;
            if (is_far_) {
                if (skips_block(column, columns_.count - k)) {
                    k += WidestRadii::kBlock - 1;
                    continue;
                }
                reach = reach_to(widest_.of_columns[column]);
                if (distance_to(column, column + 1) >= reach) continue;
            }
            if (visit(column, reach)) return true;
        }
        return false;
    }

private:
    // Whether a block of columns begins at `column`, ends within the `left` columns still to visit,
    // and has no conflict.
    bool skips_block(std::uint32_t column, std::uint32_t left) const {
        constexpr std::uint32_t kBlock = WidestRadii::kBlock;
        return column % kBlock == 0 && std::min(left, lattice_.round.columns - column) >= kBlock &&
               distance_to(column, column + kBlock) >= reach_to(widest_.of_blocks[column / kBlock]);
    }
    // Conflicts with radii up to `widest` are nearer than this many lattice steps. 0: no conflict.
    std::uint32_t reach_to(std::uint32_t widest) const {
        if (widest == 0) return 0;
        return std::min(
            reach_, portable::twice_metric_radius(lattice_.metric(), radius_, widest) / 512 + 1);
    }
    std::uint32_t distance_to(std::uint32_t begin, std::uint32_t end) const {
        const std::uint32_t low = lattice_.begins[begin];
        const std::uint32_t last = lattice_.begins[end] - 1;
        if (low <= x_ && x_ <= last) return 0;
        const std::uint32_t period = lattice_.round.plan.period_x;
        return std::min(portable::axis_distance(x_, low, period),
                        portable::axis_distance(x_, last, period));
    }

    const Lattice& lattice_;
    std::uint32_t x_;
    std::uint32_t radius_;
    std::uint32_t reach_;  // in lattice steps
    const WidestRadii& widest_;
    portable::Stretch columns_;
    bool is_far_;
};

}  // namespace lacuna::cpu

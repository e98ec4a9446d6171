// The sample grid: the samples of all earlier rounds by where they lie, at most one in each of its
// cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "plan/plan.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/sample_grid.h"

namespace lacuna::cpu {

class SampleGrid {
public:
    // Room for the plan's samples; clear() all columns of cells before anything else.
    explicit SampleGrid(const Plan& plan)
        : plan_(plan),
          stride_(plan.grid_rows + kMargin),
          slots_(std::make_unique_for_overwrite<Sample[]>((plan.grid_columns + kMargin) *
                                                          std::size_t{stride_})) {}

    std::uint32_t columns() const { return plan_.grid_columns + kMargin; }
    // Empties the columns of cells [begin, end).
    void clear(std::uint32_t begin, std::uint32_t end) {
        std::fill(column(begin), column(end), Sample{NO_SAMPLE, NO_SAMPLE});
    }
    // The cells of one column of them, row by row.
    Sample* column(std::uint32_t index) { return &slots_[std::size_t{index} * stride_]; }
    const Sample* column(std::uint32_t index) const {
        return &slots_[std::size_t{index} * stride_];
    }

    // SampleGrid may be filled in parallel: no two samples share one.
    void insert(Sample sample) {
        column(sample.x / plan_.grid_side)[sample.y / plan_.grid_side] = sample;
    }

    // Whether some sample is closer than the radius.
    bool is_covered(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t r = plan_.radius;
        if (x >= r && y >= r && x < plan_.width - r && y < plan_.height - r && r < plan_.width &&
            r < plan_.height)
            return is_covered_inside(x, y);
        bool covered = false;
        for_each_near(x, x + 1, y, y + 1, [&](Sample sample) {
            covered |= portable::conflicts(sample.x, sample.y, x, y, plan_.period_x, plan_.period_y,
                                           plan_.radius_squared);
        });
        return covered;
    }

    // Asks memory for the cells near (x, y), which are to be looked at soon. Inlined by force: a
    // compiler that sees no effect leaves the call out.
    [[gnu::always_inline]] void fetch_near(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t r = plan_.radius;
        if (x < r || y < r) return;
        const Sample* const first = column((x - r) / plan_.grid_side) + (y - r) / plan_.grid_side;
        for (std::size_t i = 0; i < 4; ++i) {
            __builtin_prefetch(first + i * stride_);
            __builtin_prefetch(first + i * stride_ + 3);
        }
    }

    // Visits the samples in all cells within the radius of [x_begin, x_end) x [y_begin, y_end),
    // around the torus too. On a torus of few cells some more than once.
    template <typename Visit>
    void for_each_near(std::uint32_t x_begin, std::uint32_t x_end, std::uint32_t y_begin,
                       std::uint32_t y_end, Visit visit) const {
        const std::uint32_t x_windows = plan_.period_x != 0 ? 3 : 1;
        const std::uint32_t y_windows = plan_.period_y != 0 ? 3 : 1;
        for (std::uint32_t i = 0; i < x_windows; ++i) {
            const auto [x_low, x_high] = near(i, x_begin, x_end, plan_.width);
            for (std::uint32_t grid_x = x_low; grid_x <= x_high; ++grid_x) {
                for (std::uint32_t j = 0; j < y_windows; ++j) {
                    const auto [y_low, y_high] = near(j, y_begin, y_end, plan_.height);
                    for (std::uint32_t grid_y = y_low; grid_y <= y_high; ++grid_y) {
                        const Sample sample = column(grid_x)[grid_y];
                        if (sample.x != NO_SAMPLE) visit(sample);
                    }
                }
            }
        }
    }

private:
    // Empty rows and columns past the last, so that a block of cells needs no bounds.
    static constexpr std::uint32_t kMargin = 3;

    struct Stretch {
        std::uint32_t low;
        std::uint32_t high;
    };
    Stretch near(std::uint32_t window, std::uint32_t begin, std::uint32_t end,
                 std::uint32_t length) const {
        const std::uint32_t r = plan_.radius;
        const std::uint32_t side = plan_.grid_side;
        return {portable::near_low(window, begin, end, r, length, side),
                portable::near_high(window, begin, end, r, length, side)};
    }

    // A disk that touches no edge lies within 4 x 4 cells, 2 sqrt(2) being less than 3. No branch:
    // where a sample lies cannot be foretold. As signed numbers the coordinates of NO_SAMPLE are
    // -1, farther away than the radius.
    bool is_covered_inside(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t grid_x = (x - plan_.radius) / plan_.grid_side;
        const std::uint32_t grid_y = (y - plan_.radius) / plan_.grid_side;
        const auto radius_squared = static_cast<std::int64_t>(plan_.radius_squared);
        const auto square = [](std::uint32_t a, std::uint32_t b) {
            const std::int64_t difference = static_cast<std::int32_t>(a - b);
            return difference * difference;
        };
        bool covered = false;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Sample* const cells = column(grid_x + i) + grid_y;
            for (std::uint32_t j = 0; j < 4; ++j)
                covered |= square(x, cells[j].x) + square(y, cells[j].y) < radius_squared;
        }
        return covered;
    }

    const Plan& plan_;
    std::uint32_t stride_;
    std::unique_ptr<Sample[]> slots_;
};

}  // namespace lacuna::cpu

// The sample grid: the samples of all earlier rounds by where they lie, at most one in each of its
// cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "backends/backend.h"
#include "backends/columns.h"
#include "backends/cpu/vectors.h"
#include "base/large_pages.h"
#include "plan/plan.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/status.h"
#include "portable/stretch.h"

namespace lacuna::cpu {

// Divides numbers below 2^31 by a divisor of 2 to 2^31, exactly, in the time of a multiplication.
// The inverse, 2^64 / divisor, is rounded up, which adds less than 1 / divisor to the result.
class Divisor {
public:
    explicit Divisor(std::uint32_t divisor) : inverse_(~std::uint64_t{0} / divisor + 1) {}
    friend std::uint32_t operator/(std::uint32_t dividend, Divisor divisor) {
        __extension__ using Wide = unsigned __int128;
        return static_cast<std::uint32_t>(Wide{dividend} * divisor.inverse_ >> 64);
    }

private:
    std::uint64_t inverse_;
};

class SampleGrid {
public:
    using Active = Box;  // an active box
    static Active active(const Box& box, std::uint32_t) { return box; }
    static const Box& box_of(const Active& active) { return active; }
    // The line of a box or position, which is what Candidate::line holds, and the line's column.
    std::uint32_t line_of(const Active& active) const { return active.x / plan_.strip_width; }
    std::uint32_t line_at(std::uint32_t x, std::uint32_t) const { return x / plan_.strip_width; }
    std::uint32_t column_of(std::uint32_t line) const {
        return portable::column_of_line(line, plan_.lines, count_columns(plan_));
    }

    // Makes room for the plan's samples. Cells hold nothing valid before clear().
    explicit SampleGrid(const Plan& plan)
        : plan_(plan),
          vectors_(vectors_for(plan.radius)),
          side_(plan.grid().side),
          stride_(plan.grid().rows + kMargin),
          slots_(std::make_unique_for_overwrite<Sample[]>((plan.grid().columns + kMargin) *
                                                          std::size_t{stride_})) {
        ask_for_large_pages(slots_.get(), (plan.grid().columns + kMargin) * std::size_t{stride_});
    }

    // Empties part number `share` of `shares` equal parts of the cells.
    void clear(std::uint32_t share, std::uint32_t shares) {
        const std::size_t columns = plan_.grid().columns + kMargin;
        std::fill(slots_.get() + share * columns / shares * stride_,
                  slots_.get() + (share + 1) * columns / shares * stride_, kNone);
    }
    // One column of cells, row by row.
    Sample* column(std::uint32_t index) { return &slots_[std::size_t{index} * stride_]; }
    const Sample* column(std::uint32_t index) const {
        return &slots_[std::size_t{index} * stride_];
    }

    // May run in parallel: no two samples lie in the same cell.
    void insert(const Candidate& sample) { cell_of(sample) = {sample.x, sample.y}; }

    // Whether some sample is closer than the radius. A disk is 2 sqrt(2) < 3 cells wide and lies in
    // 4 x 4 cells. Away from corners all are compared without a branch, which could not be
    // predicted; on a torus a candidate at an edge has an image beyond the opposite edge.
    bool is_covered(const Candidate& candidate) const {
        const std::uint32_t x = candidate.x;
        const std::uint32_t y = candidate.y;
        if (is_inside(x, x + 1, y, y + 1)) return is_any_closer(x, y);
        const std::int64_t image_x = image_of(x, plan_.width, plan_.period_x);
        const std::int64_t image_y = image_of(y, plan_.height, plan_.period_y);
        const std::uint32_t r = plan_.radius;
        if (is_inside(x, x + 1, r, r + 1))
            return is_any_closer(x, y) || (image_y != y && is_any_closer(x, image_y));
        if (is_inside(r, r + 1, y, y + 1))
            return is_any_closer(x, y) || (image_x != x && is_any_closer(image_x, y));
        bool covered = false;
        for_each_cell_near(x, x + 1, y, y + 1, [&](Sample cell) {
            covered |=
                (cell.x != NO_SAMPLE) & portable::are_closer(cell.x, cell.y, x, y, plan_.period_x,
                                                             plan_.period_y, plan_.radius_squared);
        });
        return covered;
    }

    // A mark stands in an empty cell until a sample is inserted there or the mark is removed. The
    // cell still counts as empty.
    void mark(const Candidate& at) {
        Sample& cell = cell_of(at);
        if (cell == kNone) cell = kMark;
    }
    // Whether a mark stands within the radius, or a little farther away.
    bool has_mark_near(const Candidate& at) const {
        bool is_marked = false;
        for_each_cell_near(at.x, at.x + 1, at.y, at.y + 1,
                           [&](Sample cell) { is_marked |= cell == kMark; });
        return is_marked;
    }
    // Removes all marks; those that were marked are `marked` among the candidates.
    void unmark_all(std::span<const Candidate> candidates, std::span<const std::uint32_t> marked) {
        for (const std::uint32_t i : marked)
            if (Sample& cell = cell_of(candidates[i]); cell == kMark) cell = kNone;
    }

    // Sets Snapshot::grid, where the cells of `left_out` are empty.
    void snapshot(Snapshot& snapshot, std::span<const Sample> left_out) const {
        const auto& [side, columns, rows] = plan_.grid();
        for (std::uint32_t i = 0; i < columns; ++i)
            snapshot.grid.insert(snapshot.grid.end(), column(i), column(i) + rows);
        for (const Sample sample : left_out)
            snapshot.grid[std::size_t{sample.x / side} * rows + sample.y / side] = kNone;
    }
    void restore(const Snapshot& snapshot) {
        clear(0, 1);  // the margin, too, which is in no snapshot
        for (std::uint32_t i = 0; i < plan_.grid().columns; ++i)
            std::copy_n(&snapshot.grid[std::size_t{i} * plan_.grid().rows], plan_.grid().rows,
                        column(i));
    }

    const Plan& plan() const { return plan_; }

    // Prefetch what is read about a candidate.
    [[gnu::always_inline]] void fetch(const Candidate& later) const {
        fetch_near(later.x, later.y);
    }
    void fetch_sooner(const Candidate&) const {}
    // Prefetches the cells near (x, y). Inlined by force, because compilers drop a call without
    // visible effect.
    [[gnu::always_inline]] void fetch_near(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t r = plan_.radius;
        if (x < r || y < r) return;
        const Sample* const first = column((x - r) / side_) + (y - r) / side_;
        for (std::size_t i = 0; i < 4; ++i) {
            __builtin_prefetch(first + i * stride_);
            __builtin_prefetch(first + i * stride_ + 3);
        }
    }

    // Visits all cells within the radius of [x_begin, x_end) x [y_begin, y_end). On a torus it goes
    // around the edges, and may visit some cells twice.
    template <typename Visit>
    void for_each_cell_near(std::uint32_t x_begin, std::uint32_t x_end, std::uint32_t y_begin,
                            std::uint32_t y_end, Visit visit) const {
        const std::uint32_t r = plan_.radius;
        const std::uint32_t side = plan_.grid().side;
        if (is_inside(x_begin, x_end, y_begin, y_end)) {
            const std::uint32_t row = (y_begin - r) / side_;
            const std::uint32_t rows = (y_end - 1 + r) / side_ - row + 1;
            const std::uint32_t last = (x_end - 1 + r) / side_;
            for (std::uint32_t i = (x_begin - r) / side_; i <= last; ++i)
                for (const Sample cell : std::span(column(i) + row, rows)) visit(cell);
            return;
        }
        const portable::Stretch columns = portable::cells_near(
            x_begin, x_end, r, plan_.width, plan_.period_x, side, plan_.grid().columns);
        const portable::Stretch rows = portable::cells_near(
            y_begin, y_end, r, plan_.height, plan_.period_y, side, plan_.grid().rows);
        for (std::uint32_t i = 0; i < columns.count; ++i) {
            const Sample* const cells =
                column(portable::nth_of_stretch(columns, i, plan_.grid().columns));
            for (std::uint32_t j = 0; j < rows.count; ++j)
                visit(cells[portable::nth_of_stretch(rows, j, plan_.grid().rows)]);
        }
    }

private:
    static constexpr Sample kNone{NO_SAMPLE, NO_SAMPLE};
    static constexpr Sample kMark{NO_SAMPLE, NO_SAMPLE - 1};

    Sample& cell_of(const Candidate& at) { return column(at.x / side_)[at.y / side_]; }

    // Whether some sample is closer than the radius to a point, of which at most one coordinate is
    // below the radius or beyond an edge. So empty cells, at (-1, -1), and marks, at (-1, -2), are
    // farther away than the radius.
    bool is_any_closer(std::int64_t x, std::int64_t y) const {
        const auto first_near = [&](std::int64_t at) {
            return static_cast<std::uint32_t>(std::max<std::int64_t>(at - plan_.radius, 0)) / side_;
        };
        return vectors_.is_any_closer(
            column(first_near(x)) + first_near(y), stride_,
            {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)}, plan_.radius_squared);
    }
    // Of a coordinate on a torus within the radius of an edge: that of its image beyond the
    // opposite edge. Otherwise the coordinate itself.
    std::int64_t image_of(std::uint32_t at, std::uint32_t size, std::uint32_t period) const {
        if (period == 0) return at;
        if (at < plan_.radius) return std::int64_t{at} + size;
        return at > size - plan_.radius ? std::int64_t{at} - size : std::int64_t{at};
    }

    // Whether [x_begin, x_end) x [y_begin, y_end), widened by the radius, touches no edge.
    bool is_inside(std::uint32_t x_begin, std::uint32_t x_end, std::uint32_t y_begin,
                   std::uint32_t y_end) const {
        const std::uint32_t r = plan_.radius;
        return x_begin >= r && y_begin >= r && r < plan_.width && r < plan_.height &&
               x_end <= plan_.width - r && y_end <= plan_.height - r;
    }

    // Empty rows and columns past the last ones, so that 4 x 4 cells need no bounds checks.
    static constexpr std::uint32_t kMargin = 3;

    const Plan& plan_;
    const Vectors& vectors_;
    Divisor side_;  // plan.grid().side
    std::uint32_t stride_;
    std::unique_ptr<Sample[]> slots_;
};

}  // namespace lacuna::cpu

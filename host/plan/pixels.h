// The position of a picture's pixels in the domain, and values over rectangles of pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "portable/radius_field.h"

namespace lacuna {

// The positions [x, x + width) times [begin, end), in grid units.
struct Box {
    std::uint32_t x;
    std::uint32_t width;
    std::uint32_t begin;
    std::uint32_t end;
    friend bool operator==(const Box&, const Box&) = default;
};

// An axis that is cut into pixels, equally long to a unit. At most 2^30 units and 2^30 pixels.
class PixelAxis {
public:
    PixelAxis(std::uint32_t length, std::uint32_t pixels);

    std::uint32_t pixels() const { return pixels_; }
    std::uint32_t pixel_of(std::uint32_t at) const {
        return static_cast<std::uint32_t>(at * scale_ >> shift_);
    }
    // The first unit of a pixel. The pixel number pixels() gives the length of the axis. If there
    // are more pixels than units, some pixels have no unit.
    std::uint32_t begin_of(std::uint32_t pixel) const {
        return portable::begin_of_pixel(pixel, pixels_, length_, static_cast<std::uint32_t>(scale_),
                                        static_cast<std::uint32_t>(scale_ >> 32), shift_);
    }

    // The numbers with which pixel_of and begin_of compute, for devices.
    std::uint32_t length() const { return length_; }
    unsigned shift() const { return shift_; }
    std::uint64_t scale() const { return scale_; }

private:
    std::uint32_t length_;
    std::uint32_t pixels_;
    unsigned shift_;
    std::uint64_t scale_;  // pixels per unit, times 2^shift_, rounded up: between 2^33 and 2^34
};

// The first and the last pixel that an interval of an axis touches.
struct PixelRange {
    std::uint32_t first;
    std::uint32_t last;
};

inline PixelRange pixels_of(const PixelAxis& axis, std::uint32_t begin, std::uint32_t end) {
    return {axis.pixel_of(begin), axis.pixel_of(end - 1)};
}

// A value for each pixel, and for squares of 2 x 2 pixels, 4 x 4 and so on the merged value of
// their pixels. merge(a, b) must not depend on the order, nor on repeated values.
template <typename Value, Value (*merge)(Value, Value)>
class Pyramid {
public:
    // `values` holds the pixels column by column.
    Pyramid(std::uint32_t columns, std::uint32_t rows, std::vector<Value> values,
            const Poll& poll = nobody_asks) {
        levels_.push_back({columns, rows, std::move(values)});
        while (levels_.back().columns > 1 || levels_.back().rows > 1) add_level(poll);
    }

    const std::vector<Value>& values() const { return levels_.front().values; }
    // Calls visit(std::span<const Value>) for each level, beginning with the single pixels.
    template <typename Visit>
    void for_each_level(Visit visit) const {
        for (const Level& level : levels_) visit(std::span<const Value>(level.values));
    }
    unsigned levels() const { return static_cast<unsigned>(levels_.size()); }
    // The merged value of a square of 2^level x 2^level pixels.
    Value at(unsigned level, std::uint32_t column, std::uint32_t row) const {
        return levels_[level].at(column, row);
    }
    Value at(std::uint32_t column, std::uint32_t row) const { return at(0, column, row); }
    // The merged value of a rectangle of pixels, and perhaps of some around it: it merges the
    // smallest squares of which at most 4 x 4 cover the rectangle.
    Value over(PixelRange columns, PixelRange rows) const {
        unsigned shift = 0;
        while ((columns.last >> shift) - (columns.first >> shift) >= kMost ||
               (rows.last >> shift) - (rows.first >> shift) >= kMost)
            ++shift;
        const Level& level = levels_[shift];
        Value all = level.at(columns.first >> shift, rows.first >> shift);
        for (std::uint32_t i = columns.first >> shift; i <= columns.last >> shift; ++i)
            for (std::uint32_t j = rows.first >> shift; j <= rows.last >> shift; ++j)
                all = merge(all, level.at(i, j));
        return all;
    }

private:
    static constexpr std::uint32_t kMost = 4;

    struct Level {
        std::uint32_t columns;
        std::uint32_t rows;
        std::vector<Value> values;
        Value at(std::uint32_t column, std::uint32_t row) const {
            return values[std::size_t{column} * rows + row];
        }
    };

    void add_level(const Poll& poll) {
        const Level& below = levels_.back();
        Level level{(below.columns + 1) / 2, (below.rows + 1) / 2, {}};
        level.values.resize(std::size_t{level.columns} * level.rows);
        const auto fill_column = [&](std::size_t index) {
            const auto i = static_cast<std::uint32_t>(index);
            const std::uint32_t right = std::min(2 * i + 1, below.columns - 1);
            for (std::uint32_t j = 0; j < level.rows; ++j) {
                const std::uint32_t up = std::min(2 * j + 1, below.rows - 1);
                level.values[index * level.rows + j] =
                    merge(merge(below.at(2 * i, 2 * j), below.at(right, 2 * j)),
                          merge(below.at(2 * i, up), below.at(right, up)));
            }
        };
        for_each_polled(level.columns, poll, fill_column, level.rows);
        levels_.push_back(std::move(level));
    }

    std::vector<Level> levels_;
};

}  // namespace lacuna

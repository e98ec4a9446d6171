// A picture stretched over the domain: where its pixels lie, and a summary of a rectangle of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace lacuna::verify {

// Pixels from `first` to `last`, both included.
struct Span {
    std::uint32_t first;
    std::uint32_t last;
};

// The pixels along one side of the domain, counted from 0 upwards.
class Axis {
public:
    Axis(double side, std::uint32_t count) : side_(side), count_(count) {}

    std::uint32_t count() const { return count_; }

    // Where pixel `i` begins. border(count()) is the end of the side.
    double border(std::uint32_t i) const { return side_ * (i / static_cast<double>(count_)); }

    // The pixel that a place lies on. A place on a border lies on the pixel that begins there. A
    // place beyond the side counts as lying on the outermost pixel.
    std::uint32_t pixel_of(double at) const {
        const double last = count_ - 1.0;
        const double guess = std::clamp(std::floor(at / side_ * count_), 0.0, last);
        auto pixel = static_cast<std::uint32_t>(guess);
        while (pixel + 1 < count_ && border(pixel + 1) <= at) ++pixel;
        while (pixel > 0 && border(pixel) > at) --pixel;
        return pixel;
    }

    // The pixels that have more than a border between two places.
    Span between(double low, double high) const {
        Span span{pixel_of(low), pixel_of(high)};
        if (span.last > span.first && border(span.last) >= high) --span.last;
        return span;
    }

    // The border nearest to the middle of two places, if one lies between them.
    std::optional<double> middle_border(double low, double high) const {
        const double middle = low + (high - low) / 2;
        const std::uint32_t pixel = pixel_of(middle);
        std::optional<double> nearest;
        for (const double at : {border(pixel), border(pixel + 1)})
            if (at > low && at < high &&
                (!nearest || std::abs(at - middle) < std::abs(*nearest - middle)))
                nearest = at;
        return nearest;
    }

private:
    double side_;
    std::uint32_t count_;
};

// Summaries of rectangles of pixels. Leaves has columns(), rows(), and at(column, row), which is
// the Summary of one pixel. Summary() is the summary of no pixel, and += adds that of other pixels.
template <typename Leaves>
class Pyramid {
public:
    using Summary = typename Leaves::Summary;

    explicit Pyramid(Leaves leaves) : leaves_(std::move(leaves)) {
        std::uint32_t columns = leaves_.columns();
        std::uint32_t rows = leaves_.rows();
        while (columns > 1 || rows > 1) {
            const std::uint32_t level = static_cast<std::uint32_t>(levels_.size());
            Level above{(columns + 1) / 2, {}};
            const std::uint32_t rows_above = (rows + 1) / 2;
            above.sums.resize(std::size_t{above.columns} * rows_above);
            for (std::uint32_t row = 0; row < rows; ++row)
                for (std::uint32_t column = 0; column < columns; ++column)
                    above.sums[std::size_t{row / 2} * above.columns + column / 2] +=
                        at(level, column, row);
            levels_.push_back(std::move(above));
            columns = (columns + 1) / 2;
            rows = rows_above;
        }
    }

    const Leaves& leaves() const { return leaves_; }

    // The summary of a rectangle. It is exact up to four pixels a side. For a larger rectangle it
    // includes a few pixels beside it, which are in the same squares of the pyramid.
    Summary over(Span columns, Span rows) const {
        constexpr std::uint32_t kFew = 4;
        std::uint32_t level = 0;
        while ((columns.last >> level) - (columns.first >> level) >= kFew ||
               (rows.last >> level) - (rows.first >> level) >= kFew)
            ++level;
        Summary sum;
        for (std::uint32_t row = rows.first >> level; row <= rows.last >> level; ++row)
            for (std::uint32_t column = columns.first >> level; column <= columns.last >> level;
                 ++column)
                sum += at(level, column, row);
        return sum;
    }

private:
    struct Level {
        std::uint32_t columns;
        std::vector<Summary> sums;
    };

    Summary at(std::uint32_t level, std::uint32_t column, std::uint32_t row) const {
        if (level == 0) return leaves_.at(column, row);
        const Level& squares = levels_[level - 1];
        return squares.sums[std::size_t{row} * squares.columns + column];
    }

    Leaves leaves_;
    std::vector<Level> levels_;  // level i has squares of 2^(i + 1) pixels a side
};

}  // namespace lacuna::verify

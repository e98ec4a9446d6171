// A Hilbert curve through the pixels of a grid. It begins at a random place, and is turned and
// mirrored at random.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "rounds/random.h"

namespace lacuna {

// A position in a square, in 2^-16 of its side.
struct InSquare {
    std::uint32_t x;
    std::uint32_t y;
};

// The position at `rank`, in 2^-32 of its length, of the Hilbert curve from the lower left corner
// of a square to its lower right one.
inline InSquare at_rank(std::uint32_t rank) {
    InSquare at{0, 0};
    for (std::uint32_t side = 1; side < 1u << 16; side *= 2, rank /= 4) {
        const bool right = (rank & 2) != 0;
        const bool upper = ((rank & 1) != 0) != right;
        if (!upper) {
            if (right) at = {side - 1 - at.x, side - 1 - at.y};
            std::swap(at.x, at.y);
        }
        at.x += right ? side : 0;
        at.y += upper ? side : 0;
    }
    return at;
}

struct Cell {
    std::int64_t x;
    std::int64_t y;
    friend Cell operator+(Cell a, Cell b) { return {a.x + b.x, a.y + b.y}; }
    friend Cell operator*(Cell a, std::int64_t by) { return {a.x * by, a.y * by}; }
};

// A square of cells that the curve passes: from a corner along one side to the next corner.
struct Square {
    Cell corner;  // where four cells meet
    Cell along;   // one cell along the first side
    Cell across;  // one cell into the square
    std::int64_t side;

    Cell lowest() const {
        const Cell end = corner + (along + across) * side;
        return {std::min(corner.x, end.x), std::min(corner.y, end.y)};
    }
    // From the lowest corner on, in cells.
    std::pair<double, double> at(std::uint32_t rank) const {
        const InSquare in = at_rank(rank);
        const auto share = [](std::uint32_t i) { return (i + 0.5) * 0x1p-16; };
        const double far = share(in.x), deep = share(in.y);
        const auto on_axis = [&](std::int64_t one, std::int64_t other) {
            const double way = one != 0 ? far : deep;
            return (one + other > 0 ? way : 1 - way) * static_cast<double>(side);
        };
        return {on_axis(along.x, across.x), on_axis(along.y, across.y)};
    }
};

// Calls enter(square) for a square and, where this returns true, for its quarters, in the order of
// the curve.
template <typename Enter>
void follow_curve(const Square& square, const Enter& enter) {
    if (!enter(square)) return;
    const auto& [corner, along, across, side] = square;
    const std::int64_t half = side / 2;
    const Cell middle = corner + (along + across) * half;
    follow_curve(Square{corner, across, along, half}, enter);
    follow_curve(Square{corner + across * half, along, across, half}, enter);
    follow_curve(Square{middle, along, across, half}, enter);
    follow_curve(Square{middle + along * half, across * -1, along * -1, half}, enter);
}

// Pixels, each cut into cells. On a torus the grid wraps.
struct PixelGrid {
    std::uint32_t columns;
    std::uint32_t rows;
    std::uint32_t cut_x;  // cells in a pixel's width
    std::uint32_t cut_y;
    bool wraps;

    std::uint64_t width() const { return std::uint64_t{columns} * cut_x; }  // in cells
    std::uint64_t height() const { return std::uint64_t{rows} * cut_y; }
};

// A part of the curve within one pixel.
struct InPixel {
    std::size_t pixel;  // row by row from the lowest
    Square square;
    // The square's lowest corner, in cells of the grid. On a torus the square may reach beyond the
    // grid, and goes on at the other side.
    std::uint64_t x;
    std::uint64_t y;
    std::uint64_t cells() const { return static_cast<std::uint64_t>(square.side * square.side); }
};

// The grid lies at a random place of a plane of equal squares, each with a Hilbert curve. So its
// cells have equal chances to lie at a corner of the curve, or on both sides of a line that it does
// not cross. A torus is also cut open at a random place.
class RandomCurve {
public:
    // `stream` of the random numbers.
    RandomCurve(const PixelGrid& grid, std::uint64_t seed, std::uint32_t stream)
        : grid_(grid),
          side_(std::bit_ceil(std::max(grid.width(), grid.height()))),
          x_{grid.width(), grid.cut_x},
          y_{grid.height(), grid.cut_y} {
        const RandomBits place = random_bits(seed, 0, stream);
        const RandomBits cut = random_bits(seed, 1, stream);
        const RandomBits turn = random_bits(seed, 2, stream);
        x_.place = scaled(place.first, side_);
        y_.place = scaled(place.second, side_);
        if (grid.wraps) {
            x_.cut_open = scaled(cut.first, x_.cells);
            y_.cut_open = scaled(cut.second, y_.cells);
        }
        turn_ = turn.first;
        phase_ = static_cast<std::uint32_t>(turn.second >> 32);
    }

    // A random number for where the curve begins to be divided, in 2^-32 of a part.
    std::uint32_t phase() const { return phase_; }

    // Calls visit(InPixel) for all cells of the grid, in the order of the curve.
    template <typename Visit>
    void follow(const Visit& visit) const {
        const auto end = static_cast<std::int64_t>(side_);
        const bool is_right = (turn_ & 1) != 0, is_upper = (turn_ & 2) != 0;
        Square all{{is_right ? end : 0, is_upper ? end : 0},
                   {is_right ? -1 : 1, 0},
                   {0, is_upper ? -1 : 1},
                   end};
        if ((turn_ & 4) != 0) std::swap(all.along, all.across);
        follow_curve(all, [&](const Square& square) { return enter(square, visit); });
    }

private:
    // The cells of the grid on an axis.
    struct Axis {
        std::uint64_t cells;
        std::uint32_t cut;
        std::uint64_t place = 0;     // of the grid's first cell on the curve's square
        std::uint64_t cut_open = 0;  // the cell at which a torus begins

        std::uint64_t on_grid(std::uint64_t cell) const {
            const std::uint64_t at = cell + cut_open;
            return at < cells ? at : at - cells;
        }
        std::uint32_t pixel(std::uint64_t cell) const {
            const auto at = static_cast<std::uint32_t>(on_grid(cell));
            return cut == 1 ? at : at / cut;  // a division takes as long as all the rest
        }
        bool are_in_one_pixel(std::uint64_t cell, std::uint64_t side) const {
            return side == 1 ||
                   (side <= cut && cell + side <= cells && pixel(cell) == pixel(cell + side - 1));
        }
    };

    // Returns whether the square's quarters are to be entered.
    template <typename Visit>
    bool enter(const Square& square, const Visit& visit) const {
        const Cell lowest = square.lowest();
        const auto side = static_cast<std::uint64_t>(square.side);
        const auto from_grid = [&](std::int64_t cell, const Axis& axis) {
            return (static_cast<std::uint64_t>(cell) - axis.place) & (side_ - 1);
        };
        const std::uint64_t x = from_grid(lowest.x, x_), y = from_grid(lowest.y, y_);
        const auto is_beyond = [&](std::uint64_t cell, const Axis& axis) {
            return cell >= axis.cells && cell + side <= side_;
        };
        if (is_beyond(x, x_) || is_beyond(y, y_)) return false;
        if (!x_.are_in_one_pixel(x, side) || !y_.are_in_one_pixel(y, side)) return true;
        visit(InPixel{std::size_t{y_.pixel(y)} * grid_.columns + x_.pixel(x), square, x_.on_grid(x),
                      y_.on_grid(y)});
        return false;
    }

    PixelGrid grid_;
    std::uint64_t side_;  // of the square, in cells: a power of two
    Axis x_;
    Axis y_;
    std::uint64_t turn_;
    std::uint32_t phase_;
};

}  // namespace lacuna

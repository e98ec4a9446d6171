// A Hilbert curve through a grid of any shape, and the Hilbert curve within a cell of it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace lacuna {

struct Cell {
    std::int64_t x;
    std::int64_t y;
};

// Calls visit(Cell) for each cell of a grid, from neighbour to neighbour. At most one step, where
// sides are odd, is diagonal. The recursion is the generalized Hilbert curve of Jakub Cerveny
// (https://github.com/jakubcerveny/gilbert): a rectangle is given by its first corner, the side
// along which the curve goes on the whole, and the other side.
template <typename Visit>
void for_each_on_curve(Cell at, Cell along, Cell across, const Visit& visit) {
    const auto length = [](Cell side) { return std::abs(side.x + side.y); };
    const auto sign = [](std::int64_t a) { return std::int64_t{a > 0} - std::int64_t{a < 0}; };
    const auto unit = [&](Cell side) { return Cell{sign(side.x), sign(side.y)}; };
    const auto plus = [](Cell a, Cell b) { return Cell{a.x + b.x, a.y + b.y}; };
    const auto minus = [](Cell a, Cell b) { return Cell{a.x - b.x, a.y - b.y}; };
    if (length(along) == 1 || length(across) == 1) {
        const Cell& side = length(across) == 1 ? along : across;
        for (std::int64_t i = length(side); i > 0; --i, at = plus(at, unit(side))) visit(at);
        return;
    }
    // Half of a side, but an even number of cells where that can be.
    const auto half_of = [&](Cell side) {
        const Cell half{side.x >> 1, side.y >> 1};
        return length(half) % 2 != 0 && length(side) > 2 ? plus(half, unit(side)) : half;
    };
    if (2 * length(along) > 3 * length(across)) {
        const Cell half = half_of(along);
        for_each_on_curve(at, half, across, visit);
        for_each_on_curve(plus(at, half), minus(along, half), across, visit);
        return;
    }
    const Cell half = half_of(across);
    const Cell first{along.x >> 1, along.y >> 1};
    const Cell last = plus(minus(along, unit(along)), minus(half, unit(half)));
    for_each_on_curve(at, half, first, visit);
    for_each_on_curve(plus(at, half), along, minus(across, half), visit);
    for_each_on_curve(plus(at, last), Cell{-half.x, -half.y}, minus(first, along), visit);
}

template <typename Visit>
void for_each_on_curve(std::uint32_t columns, std::uint32_t rows, const Visit& visit) {
    const Cell right{columns, 0};
    const Cell up{0, rows};
    if (columns >= rows)
        for_each_on_curve(Cell{0, 0}, right, up, visit);
    else
        for_each_on_curve(Cell{0, 0}, up, right, visit);
}

// A position in a cell, in 2^-16 of its sides.
struct InCell {
    std::uint32_t x;
    std::uint32_t y;
};

// The position at `rank`, in 2^-32 of its length, of the Hilbert curve from the lower left corner
// of a cell to its lower right one.
inline InCell at_rank(std::uint32_t rank) {
    InCell at{0, 0};
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

// The curve's way through a cell: from one corner to the next along an edge.
struct Way {
    bool from_right;
    bool from_top;
    bool is_upright;  // the two corners lie above each other

    InCell at(std::uint32_t rank) const {
        constexpr std::uint32_t kLast = (1u << 16) - 1;
        InCell at = at_rank(rank);
        if (is_upright) std::swap(at.x, at.y);
        return {from_right ? kLast - at.x : at.x, from_top ? kLast - at.y : at.y};
    }
};

// The way through a cell that the curve leaves by a step of (dx, dy); it then begins the way
// through the next cell at the corner that the cells have in common.
inline Way way_to(bool& at_right, bool& at_top, std::int64_t dx, std::int64_t dy) {
    Way way{at_right, at_top, false};
    const bool is_at_edge = dx != 0 ? at_right == (dx > 0) : at_top == (dy > 0);
    way.is_upright = (dx != 0) == is_at_edge;
    (way.is_upright ? at_top : at_right) ^= true;
    (dx != 0 ? at_right : at_top) = dx != 0 ? dx < 0 : dy < 0;
    return way;
}

}  // namespace lacuna

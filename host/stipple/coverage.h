// How much paper dots and strokes cover.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna::stippling {

// Positions on a domain, in rows and columns, of which dots and strokes cover some. Its side of a
// position is nearly that of a square with the area of the domain over `positions`.
class Raster {
public:
    Raster(const Domain& domain, double positions);

    void cover_ellipse(Point middle, const Ellipse& dot);
    // A line 2 a long and 2 b wide, with round ends.
    void cover_stroke(Point middle, const Ellipse& stroke);

    std::size_t columns() const { return static_cast<std::size_t>(columns_); }
    std::size_t rows() const { return static_cast<std::size_t>(rows_); }
    // Row by row, from below: 1 where it is covered.
    std::span<const std::uint8_t> covered() const { return covered_; }
    void clear();

private:
    template <typename Chord>
    void cover(Point middle, double reach, Chord chord);
    void put(double column, double row);

    Domain domain_;
    double columns_;
    double rows_;
    std::vector<std::uint8_t> covered_;
};

// The area of the domain that dots cover together, each `times` as wide as its ellipse. It is
// counted at some 16 positions a dot, 2^16 to 2^18 in all.
double covered_area(std::span<const Point> points, std::span<const Ellipse> dots, double times,
                    const Domain& domain);

}  // namespace lacuna::stippling

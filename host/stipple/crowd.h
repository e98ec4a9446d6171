// Dots while they are moved: finds whether another dot is too near to a place.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna::stippling {

class Crowd {
public:
    // The points must lie in the domain. `diameters` must outlive this object.
    Crowd(std::span<const Point> points, std::span<const double> diameters, const Domain& domain);

    Point at(std::size_t dot) const { return points_[dot]; }
    void move(std::size_t dot, Point to);

    // Whether a dot moved to this place would come nearer to some other dot than now, and nearer
    // than kApart of the mean of both diameters.
    bool is_too_near(std::size_t dot, Point to) const;

    static constexpr double kApart = 0.125;

private:
    // A square part of the domain, of the grid that finds dots.
    struct Cell {
        std::int64_t column;
        std::int64_t row;
    };
    static constexpr std::uint32_t kNone = UINT32_MAX;

    Cell cell_of(Point place) const;
    std::uint32_t& first_in(Cell cell);
    double squared_distance(Point a, Point b) const;

    std::vector<Point> points_;
    std::span<const double> diameters_;
    Domain domain_;
    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<std::uint32_t> first_;  // of each cell, a dot in it, or kNone
    std::vector<std::uint32_t> next_;   // of each dot, another dot in its cell, or kNone
};

}  // namespace lacuna::stippling

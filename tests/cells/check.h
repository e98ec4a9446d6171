// The promises of mode cells for a set, checked as a user would: only from the request, the field
// and the returned points. By brute force or, for large sets, by a grid. No code of the samplers is
// used.
#pragma once

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lacuna::tests {

enum class By { brute_force, grid };

class CellsCheck {
public:
    // request.scale and request.paper2011.lines_per_radius must be set.
    CellsCheck(const Request& request, std::vector<Point> points);

    // Every point lies where importance is over 0, in the middle of a cell of the lattice. That has
    // ceil(m W / r_min) columns, and the number of rows that makes both steps most alike.
    testing::AssertionResult is_on_the_lattice() const;
    // Every two points keep the metric's distance: in double, in the user's units, no tolerance.
    testing::AssertionResult keeps_its_distances(By by) const;
    // Every lattice point with importance is closer to some point than the metric asks, in lattice
    // steps. Radii are rounded up to 1/256 of a step, which is the tolerance.
    testing::AssertionResult is_maximal(By by) const;

    std::int64_t columns() const { return columns_; }  // columns of the lattice
    std::int64_t rows() const { return rows_; }

private:
    // A lattice point, the lowest row first.
    struct Place {
        std::int64_t x;
        std::int64_t y;
    };
    class Buckets;

    Place place_of(Point point) const;
    std::size_t pixel_of(Place place) const;
    double radius_at(Place place) const;  // in the user's units
    double metric_of(double a, double b) const;
    double distance(Point a, Point b) const;
    bool blocks(Place sample, Place other) const;
    bool is_blocked_by_any(Place place) const;
    testing::AssertionResult not_blocked(Place place) const;
    testing::AssertionResult check_pair(std::size_t i, std::size_t j) const;
    std::vector<bool> blocked_within_own_radius() const;

    Request request_;
    std::vector<Point> points_;
    std::vector<Place> places_;  // of the points
    std::int64_t columns_;
    std::int64_t rows_;
    double step_;
    double least_radius_;
};

}  // namespace lacuna::tests

// The judge of mode cells, on the lattice that lacuna.h promises: only from the request, the field
// and the points.
#pragma once

#include <lacuna/sample.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lacuna::judge {

class CellsJudge {
public:
    // request.scale and request.paper2011.lines_per_radius must be set.
    CellsJudge(const Request& request, std::span<const Point> points);

    // A point that does not lie in the middle of a cell whose importance is over 0, or two points
    // that are closer than the metric asks, in double and in the user's units. Empty if there are
    // none. The lattice has ceil(m W / r_min) columns, and the number of rows that makes both steps
    // most alike.
    std::string fault() const;
    // A lattice point with importance that is not closer to some point than the metric asks, in
    // lattice steps. Radii are rounded up to 1/256 of a step, which is the tolerance. Empty if
    // there is none.
    std::string room() const;

    std::int64_t columns() const { return columns_; }  // columns of the lattice
    std::int64_t rows() const { return rows_; }

private:
    // A lattice point, the lowest row first.
    struct Place {
        std::int64_t x, y;
    };
    using Is = std::function<bool(std::size_t)>;

    Place place_of(Point point) const;
    std::size_t pixel_of(Place place) const;
    double radius_at(Place place) const;  // in the user's units
    double metric_of(double a, double b) const;
    bool blocks(Place sample, Place other) const;
    std::vector<bool> blocked_within_own_radius() const;
    bool any_near(Place place, double steps, const Is& is_it) const;

    const Request& request_;
    std::vector<Point> points_;
    std::vector<Place> places_;  // of the points
    std::int64_t columns_, rows_;
    double step_;
    // The points in squares of `side_` lattice steps, to find all that are near.
    std::int64_t side_, across_, up_;
    std::vector<std::vector<std::size_t>> squares_;
};

}  // namespace lacuna::judge

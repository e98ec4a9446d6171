// The judge of sets: looks at all pairs of points, and at spots where room would be left if there
// were any. It knows a request, the points and what lacuna.h promises, and nothing of how samplers
// or proofs work.
#pragma once

#include <lacuna/sample.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "judge/plane.h"

namespace lacuna::judge {

using Random = std::mt19937_64;

inline double any_in(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
inline Point any_place(Random& random, const Domain& domain) {
    return {domain.x0 + any_in(random, 0, domain.width),
            domain.y0 + any_in(random, 0, domain.height)};
}

// A disk, or the ellipse that holds an offset (x, y) if xx x^2 + 2 xy x y + yy y^2 < 1.
struct Shape {
    double shorter, longer;
    double xx = 0, xy = 0, yy = 0;
    double length_of(Point way) const;  // 1 at the edge
    // How far the end of a way is from the edge of the shape that is `f` times as large; of an
    // ellipse in proportion to its shorter radius.
    double over(Point way, double f) const;
};

class Judge {
public:
    // `size` is the radius or scale, with classes the least distance. A mask that was drawn from
    // polygons is judged by these: only spots deeper in them than `edge` need be covered. The
    // request and the polygons must outlive the judge. With classes each point has one.
    Judge(const Request& request, std::span<const Point> points,
          std::span<const std::uint8_t> classes, double size,
          std::span<const PolygonSet> polygons = {}, double edge = 0);
    Judge(const Request& request, const Result& set)
        : Judge(request, set.points, set.classes,
                request.field == nullptr ? set.radius : set.scale) {}

    // What is wrong with the points: one lies where none may, or two are too close. Empty if
    // nothing is.
    std::string fault() const;
    // The first point that lies where none may.
    std::optional<std::size_t> astray() const;

    // The two points whose distance is the least share of their limit, below 1 if too close.
    struct Closest {
        std::size_t first = 0, second = 0;
        double share = kInfinity;
    };
    Closest closest() const;
    double share_of(std::size_t i, std::size_t j) const;

    // How far an open spot is over the limit of the point that covers it best, for one more point
    // of a class. Negative if it is covered.
    double room(Point spot, std::uint8_t kind = 0) const;
    // The open spot with the most room that is found for any class that is drawn.
    struct Gap {
        Point at{0, 0};
        std::uint8_t kind = 0;
        double room = -kInfinity;
    };
    Gap largest_gap(Random& random) const;
    // The same for one class near a place, by ever smaller steps.
    Gap largest_gap_near(Point place, std::uint8_t kind, Random& random) const;
    // The same for any class, over a raster of (steps + 1)^2 spots that includes edges and corners.
    Gap largest_gap_of_raster(int steps) const;
    // The most room on the lines of mode lines (docs/design.md, section 5), just outside of disks.
    double most_room_on_lines() const;
    // A place where a point of the class is too close to point i, by a hundredth of their limit.
    Point too_close_to(std::size_t i, std::uint8_t kind, Random& random) const;

    // Whether a spot is open to a class, and no border of pixels or edge of the allowed part near.
    bool is_open(Point spot, std::uint8_t kind = 0) const;
    // Whether the pixel of the mask allows points, without regard to what is near.
    bool is_in_mask(Point at, std::uint8_t kind = 0) const;
    std::optional<Shape> shape_at(Point at) const;  // none where importance is 0

    // How far over its limit a covered spot may be (lacuna/verify.h).
    double tolerance() const;
    // To which part of the domain samplers may round borders of pixels.
    double blur() const;

private:
    struct Site {
        Point at;
        std::vector<Shape> shapes;  // more than one near a border of pixels
        std::uint8_t kind;
        bool is_kept;
        bool is_far = false;  // outside, too far to cover a spot of the domain
    };

    std::size_t kinds() const;
    bool is_uniform() const;
    double border(std::uint8_t kind) const;
    const Mask* mask_of(std::uint8_t kind) const;
    // The factor of two classes: their distance over the least one.
    double factor(std::uint8_t a, std::uint8_t b) const;
    double share_of(const Site& a, const Site& b) const;
    double over(const Site& site, Point spot, const Shape& own, std::uint8_t kind) const;
    std::vector<Point> near(Point at) const;
    std::vector<Shape> shapes_near(Point at) const;
    bool is_allowed(const Site& site) const;
    bool is_drawn(std::uint8_t kind) const;

    using Look = std::function<void(Point, std::uint8_t)>;
    Point boundary_of(const Site& site, double angle, std::uint8_t kind) const;
    void walk_around(const Site& site, std::uint8_t kind, Random& random, const Look& look) const;
    double sign_at(Point spot, std::uint8_t kind, std::size_t k) const;

    const Request& request_;
    const Domain& domain_;
    double size_;
    std::span<const PolygonSet> polygons_;
    double edge_;
    double least_distance_ = kInfinity;  // of classes
    double greatest_ = 1;                // of classes, over the least
    double longer_side_;                 // with the neighbours that matter
    std::size_t own_;                    // the points of the set, which come first
    std::vector<Site> sites_;            // also those of neighbours
};

}  // namespace lacuna::judge

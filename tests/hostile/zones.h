// The zones of points: the disks and ellipses that they keep free, where points may lie, and how
// much room a spot has. In doubles, from coordinates alone; no code is shared with the library.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hostile/made.h"
#include "verify/field_sets.h"

namespace lacuna::tests {

class Zones {
public:
    // `size` is the radius or scale, with classes the least distance.
    Zones(const Made& made, std::span<const Point> points, std::span<const std::uint8_t> classes,
          double size)
        : made_(made), request_(made.request), domain_(made.domain()), size_(size) {
        for (std::size_t i = 0; i < points.size(); ++i)
            sites_.push_back({points[i], shapes_near(points[i]),
                              classes.empty() ? std::uint8_t{0} : classes[i]});
        own_ = points.size();
        for (std::size_t i = 0; i < made.neighbours.size(); ++i)
            sites_.push_back({made.neighbours[i],
                              {Shape{size, size}},
                              classes.empty() ? std::uint8_t{0} : made.neighbour_classes[i]});
        least_distance_ = std::numeric_limits<double>::infinity();
        for (const double distance : request_.classes.distances)
            if (distance > 0) least_distance_ = std::min(least_distance_, distance);
    }

    double blur() const { return domain_.longer_side() * 0x1p-28; }
    // How far over its limit a covered spot may be (lacuna/verify.h). In mode cells the lattice
    // points next to a spot are covered.
    double tolerance() const {
        if (request_.mode == Mode::cells)
            return 2.5 * least_radius() / request_.paper2011.lines_per_radius.value_or(10);
        const std::size_t count = request_.classes.names.size();
        double most = least_distance_;
        for (const double distance : request_.classes.distances) most = std::max(most, distance);
        return 2 * blur() * longer_side_with_neighbours() / domain_.longer_side() *
               (count <= 4   ? 1
                : count <= 8 ? 2
                             : 4) *
               (count == 0 ? 1 : most / least_distance_);
    }

    // Of the box around the domain and the neighbours within the greatest distance.
    double longer_side_with_neighbours() const {
        double greatest = 1;
        for (const double distance : request_.classes.distances)
            greatest = std::max(greatest, distance / least_distance_);
        double left = 0, bottom = 0, right = domain_.width, top = domain_.height;
        for (const Point& at : made_.neighbours) {
            const double across = std::max({-at.x, 0.0, at.x - domain_.width});
            const double up = std::max({-at.y, 0.0, at.y - domain_.height});
            if (std::sqrt(across * across + up * up) > greatest * size_) continue;
            left = std::min(left, at.x), right = std::max(right, at.x);
            bottom = std::min(bottom, at.y), top = std::max(top, at.y);
        }
        return std::max(right - left, top - bottom);
    }

    // Whether a spot is open to a class, and no border of pixels or edge of the allowed part is
    // near.
    bool is_open(Point spot, std::uint8_t kind) const {
        const double near = request_.mode == Mode::cells ? tolerance() : 4 * blur();
        const double to_edges = std::min(std::min(spot.x, domain_.width - spot.x),
                                         std::min(spot.y, domain_.height - spot.y));
        if (to_edges < border(kind) + (border(kind) > 0 ? near : 0)) return false;
        if (!shape_at(spot) || (request_.mask != nullptr && !is_in_mask(spot))) return false;
        for (const double dx : {-near, near})
            for (const double dy : {-near, near}) {
                const Point there{spot.x + dx, spot.y + dy};
                if (pixel_of(there, made_.field) != pixel_of(spot, made_.field) ||
                    pixel_of(there, made_.mask) != pixel_of(spot, made_.mask))
                    return false;
            }
        return true;
    }

    // How far an open spot is over the limit of the point that covers it best, for one more point
    // of a class. Negative if it is covered.
    double room(Point spot, std::uint8_t kind) const {
        const Shape own = *shape_at(spot);
        double least = std::numeric_limits<double>::infinity();
        for (const Site& site : sites_) least = std::min(least, over(site, spot, own, kind));
        return least;
    }

    double least_radius() const {
        double most = request_.field == nullptr ? 1 : 0;
        if (request_.field != nullptr)
            for (const double one : made_.field.importance) most = std::max(most, one);
        return size_ / std::sqrt(most);
    }

    // Whether a moved point is on a pixel that is not white; all of an empty picture is not.
    bool has_importance(Point at, const Field& picture) const {
        bool has = picture.importance.empty();
        for_near(
            at, [&](Point near) { has = has || picture.importance[pixel_of(near, picture)] != 0; });
        return has;
    }
    bool is_in_mask(Point at) const { return made_.mask.allowed[pixel_of(at, made_.mask)] != 0; }

protected:
    // A disk, or the ellipse that holds an offset (x, y) if xx x^2 + 2 xy x y + yy y^2 < 1.
    struct Shape {
        double shorter, longer;
        double xx = 0, xy = 0, yy = 0;
        double length_of(Point way) const {
            if (xx == 0) return std::sqrt(way.x * way.x + way.y * way.y) / shorter;
            return std::sqrt(xx * way.x * way.x + 2 * xy * way.x * way.y + yy * way.y * way.y);
        }
    };
    struct Site {
        Point at;
        std::vector<Shape> shapes;  // more than one near a border of pixels
        std::uint8_t kind;
    };

    double border(std::uint8_t kind) const {
        const std::vector<double>& own = request_.classes.borders;
        return own.empty() ? request_.border : own[kind];
    }
    std::size_t kinds() const { return std::max<std::size_t>(1, request_.classes.names.size()); }
    double factor(std::uint8_t a, std::uint8_t b) const {
        return request_.classes.names.empty()
                   ? 1
                   : request_.classes.distances[a * kinds() + b] / least_distance_;
    }

    template <typename Pixels>
    std::size_t pixel_of(Point at, const Pixels& pixels) const {
        if (pixels.columns == 0) return 0;
        const verify::FieldCase seen{.name = "", .field = {}, .domain = domain_};
        return seen.pixel_of(at, pixels.columns, pixels.rows);
    }

    std::optional<Shape> shape_at(Point at) const {
        if (request_.field == nullptr) return Shape{size_, size_};
        const std::size_t pixel = pixel_of(at, made_.field);
        if (made_.field.importance[pixel] == 0) return std::nullopt;
        const double radius = size_ / std::sqrt(made_.field.importance[pixel]);
        if (made_.field.stretches.empty()) return Shape{radius, radius};
        const auto [ratio, angle] = made_.field.stretches[pixel];
        const double longer = radius * std::sqrt(ratio), shorter = radius / std::sqrt(ratio);
        const double c = std::cos(angle), s = std::sin(angle);
        const double far = 1 / (longer * longer), near = 1 / (shorter * shorter);
        return Shape{shorter, longer, c * c * far + s * s * near, c * s * (far - near),
                     s * s * far + c * c * near};
    }

    // The points within 2^-28 of the longer side of a point: samplers round borders to a grid.
    template <typename Use>
    void for_near(Point at, Use use) const {
        for (const double dx : {0.0, -blur(), blur()})
            for (const double dy : {0.0, -blur(), blur()}) use(wrapped({at.x + dx, at.y + dy}));
    }
    std::vector<Shape> shapes_near(Point at) const {
        std::vector<std::size_t> seen;
        std::vector<Shape> shapes;
        for_near(at, [&](Point near) {
            const std::size_t pixel = pixel_of(near, made_.field);
            if (std::find(seen.begin(), seen.end(), pixel) != seen.end()) return;
            seen.push_back(pixel);
            if (const auto shape = shape_at(near)) shapes.push_back(*shape);
        });
        return shapes;
    }
    Point wrapped(Point at) const {
        if (!domain_.torus) return at;
        const auto within = [](double a, double side) {
            const double there = a - side * std::floor(a / side);
            return there < side ? there : 0;
        };
        return {within(at.x, domain_.width), within(at.y, domain_.height)};
    }

    // A kept point may lie on the upper edges of a box, too.
    bool is_allowed(const Site& site, bool is_kept) const {
        const Point at = site.at;
        const double edge = border(site.kind) - (border(site.kind) > 0 ? blur() : 0);
        const bool is_below = at.x < domain_.width && at.y < domain_.height;
        if (!(domain_.contains(at) && (is_kept || is_below) && at.x >= edge && at.y >= edge &&
              domain_.width - at.x >= edge && domain_.height - at.y >= edge))
            return false;
        bool is_in = request_.mask == nullptr;
        for_near(at, [&](Point near) { is_in = is_in || is_in_mask(near); });
        return is_in && !site.shapes.empty();
    }

    bool are_in_conflict(const Site& a, const Site& b) const {
        const Point way = domain_.way(a.at, b.at);
        const double f = factor(a.kind, b.kind);
        // With either shape the two must be too close.
        for (const Shape& one : a.shapes)
            for (const Shape& other : b.shapes) {
                if (request_.mode == Mode::lines || request_.metric != Metric::min) {
                    if (!(std::hypot(way.x, way.y) < limit(one, other))) return false;
                } else if (!(one.length_of(way) < f && other.length_of(way) < f)) {
                    return false;
                }
            }
        return true;
    }
    // The least distance in mode lines, and by the metrics of mode cells.
    double limit(const Shape& a, const Shape& b) const {
        const double slack = 1 - 1e-12;  // the mean of two radii is rounded
        if (request_.mode == Mode::lines)
            return request_.paper2011.snap
                       ? size_
                       : size_ * (1 - 0.5 / request_.paper2011.lines_per_radius.value_or(30)) *
                             slack;
        if (request_.metric == Metric::mean) return (a.shorter + b.shorter) / 2 * slack;
        return std::max(a.shorter, b.shorter);
    }

    double over(const Site& site, Point spot, const Shape& own, std::uint8_t kind) const {
        const double f = factor(site.kind, kind);
        double least = std::numeric_limits<double>::infinity();
        if (f == 0) return least;
        const Point way = domain_.way(site.at, spot);
        for (const Shape& shape : site.shapes) {
            const double one = request_.metric == Metric::min
                                   ? std::max(shape.shorter * (shape.length_of(way) - f),
                                              own.shorter * (own.length_of(way) - f))
                                   : std::hypot(way.x, way.y) - limit(shape, own);
            least = std::min(least, one);
        }
        return least;
    }

    const Made& made_;
    const Request& request_;
    const verify::Domain domain_;
    const double size_;
    double least_distance_;
    std::size_t own_ = 0;      // the points of the set, which come first
    std::vector<Site> sites_;  // also those of neighbours
};

}  // namespace lacuna::tests

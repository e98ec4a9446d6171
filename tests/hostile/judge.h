// A judge of sets that shares no code with the library: it looks at all pairs of points, and at
// spots where room would be left if there were any. In doubles, from coordinates alone.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "hostile/random_request.h"

namespace lacuna::tests {

class Judge {
public:
    // `size` is the radius or scale, with classes the least distance.
    Judge(const Made& made, std::span<const Point> points, std::span<const std::uint8_t> classes,
          double size)
        : made_(made), request_(made.request), domain_(made.domain()), size_(size) {
        for (std::size_t i = 0; i < points.size(); ++i)
            sites_.push_back({points[i], shapes_near(points[i]),
                              classes.empty() ? std::uint8_t{0} : classes[i]});
        least_distance_ = std::numeric_limits<double>::infinity();
        for (const double distance : request_.classes.distances)
            if (distance > 0) least_distance_ = std::min(least_distance_, distance);
    }

    double blur() const { return domain_.longer_side() * 0x1p-28; }
    // How far over its limit a covered spot may be (lacuna/verify.h). In mode cells the lattice
    // points next to a spot are covered.
    double tolerance() const {
        if (request_.mode == Mode::cells)
            return 2.5 * least_radius() / request_.lines_per_radius.value_or(10);
        const std::size_t count = request_.classes.names.size();
        double most = least_distance_;
        for (const double distance : request_.classes.distances) most = std::max(most, distance);
        return 2 * blur() *
               (count <= 4   ? 1
                : count <= 8 ? 2
                             : 4) *
               (count == 0 ? 1 : most / least_distance_);
    }

    // What is wrong with the points; empty if nothing is.
    std::string fault() const {
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            if (!is_allowed(sites_[i])) return text_of(i) + " lies where no point may";
            for (std::size_t j = 0; j < i; ++j)
                if (are_in_conflict(sites_[i], sites_[j]))
                    return text_of(j) + " and " + text_of(i) + " are too close";
        }
        return "";
    }

    // Whether a spot is open, and no border of pixels or edge of the allowed part is near.
    bool is_open(Point spot) const {
        const double near = request_.mode == Mode::cells ? tolerance() : 4 * blur();
        const double to_edges = std::min(std::min(spot.x, domain_.width - spot.x),
                                         std::min(spot.y, domain_.height - spot.y));
        if (to_edges < request_.border + (request_.border > 0 ? near : 0)) return false;
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

    // The open spot with the most room that is found for any class that is drawn.
    struct Gap {
        Point at{0, 0};
        std::uint8_t kind = 0;
        double room = -std::numeric_limits<double>::infinity();
    };
    Gap largest_gap(std::mt19937_64& random) const {
        Gap largest;
        const auto look_at = [&](Point spot, std::uint8_t kind) {
            spot = wrapped(spot);
            if (!is_open(spot)) return;
            const double found = room(spot, kind);
            if (found > largest.room) largest = {spot, kind, found};
        };
        constexpr int kSpots = 60;
        for (std::size_t kind = 0; kind < kinds(); ++kind) {
            const std::vector<double>& weights = request_.classes.weights;
            if (!weights.empty() && weights[kind] == 0) continue;
            const auto of_kind = static_cast<std::uint8_t>(kind);
            for (int i = 0; i < kSpots; ++i) look_at(verify::any_place(random, domain_), of_kind);
            // Many classes of many points are looked at in part.
            const std::size_t step = 1 + sites_.size() * kinds() / 400;
            for (std::size_t i = random() % step; i < sites_.size(); i += step)
                walk_around(sites_[i], of_kind, random, look_at);
        }
        return largest;
    }

    // The most room on the lines of mode lines (docs/design.md, section 5), just outside of disks.
    double most_room_on_lines() const {
        const double lines =
            std::ceil(request_.lines_per_radius.value_or(30) * domain_.width / size_);
        double most = -std::numeric_limits<double>::infinity();
        for (const Site& site : sites_) {
            const double middle = site.at.x / domain_.width * lines;
            const double around = std::min(lines, std::ceil(size_ / domain_.width * lines) + 1);
            for (double line = std::floor(middle - around); line <= middle + around; ++line) {
                const double x = (line + 0.5) * domain_.width / lines;
                const double along =
                    std::sqrt(std::max(0.0, size_ * size_ - std::pow(x - site.at.x, 2)));
                for (const double y : {site.at.y - along, site.at.y + along}) {
                    const Point spot = wrapped({x, y});
                    if (along > 0 && domain_.contains(spot)) most = std::max(most, room(spot, 0));
                }
            }
        }
        return most;
    }

    // The most room for the class of a removed point near its place, by ever smaller steps.
    double most_room_near(Point gone, std::uint8_t kind, std::mt19937_64& random) const {
        double most = -std::numeric_limits<double>::infinity();
        Point barest = gone;
        double reach = domain_.longer_side();
        for (const Shape& shape : shapes_near(gone)) reach = std::min(reach, 2 * shape.longer);
        for (int i = 0; i < 3000; ++i, reach *= 0.995) {
            const Point spot = wrapped({barest.x + verify::any_in(random, -reach, reach),
                                        barest.y + verify::any_in(random, -reach, reach)});
            if (!is_open(spot)) continue;
            const double found = room(spot, kind);
            if (!(found > most)) continue;
            most = found;
            barest = spot;
        }
        return most;
    }

    // A place where a point of the class is too close to point i, by a hundredth of their limit.
    Point too_close_to(std::size_t i, std::uint8_t kind, std::mt19937_64& random) const {
        const Point on = boundary_of(sites_[i], verify::any_in(random, 0, 7), kind);
        const Point at = sites_[i].at;
        return wrapped({at.x + 0.99 * (on.x - at.x), at.y + 0.99 * (on.y - at.y)});
    }

    // How far inside of the allowed part of the polygons a spot is; infinite without polygons.
    double depth_of(Point spot, bool with_distances) const {
        double depth = std::numeric_limits<double>::infinity();
        const auto in = [&](const std::vector<PolygonRing>& rings) {
            verify::FieldCase seen;
            seen.rings = rings;
            return seen.depth_of(spot);
        };
        if (!made_.inside.empty()) depth = std::min(depth, in(made_.inside));
        if (!made_.outside.empty()) depth = std::min(depth, -in(made_.outside));
        if (!made_.avoided.empty() && with_distances)
            depth = std::min(depth, std::abs(in(made_.avoided)) - made_.polygons.back().distance);
        return depth;
    }

    double least_radius() const {
        double most = request_.field == nullptr ? 1 : 0;
        if (request_.field != nullptr)
            for (const double one : made_.field.importance) most = std::max(most, one);
        return size_ / std::sqrt(most);
    }

    bool is_in_mask(Point at) const { return made_.mask.allowed[pixel_of(at, made_.mask)] != 0; }

private:
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

    bool is_allowed(const Site& site) const {
        const Point at = site.at;
        const double edge = request_.border - (request_.border > 0 ? blur() : 0);
        if (!(at.x >= edge && at.y >= edge && at.x < domain_.width && at.y < domain_.height &&
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
            return request_.snap
                       ? size_
                       : size_ * (1 - 0.5 / request_.lines_per_radius.value_or(30)) * slack;
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

    // The spot where a point's own zone ends in a direction, for points of a class.
    Point boundary_of(const Site& site, double angle, std::uint8_t kind) const {
        const Point way{std::cos(angle), std::sin(angle)};
        const double f = factor(site.kind, kind);
        double reach = f / site.shapes.front().length_of(way);
        const auto at = [&] { return Point{site.at.x + reach * way.x, site.at.y + reach * way.y}; };
        for (int i = 0; i < 3; ++i)
            if (const auto there = shape_at(wrapped(at())))
                reach = f / std::max(there->length_of(way), site.shapes.front().length_of(way));
        return at();
    }

    // Spots around a point, just outside of its zone: at some angles, where the zone of another
    // point begins or ends, and where the allowed part does. If there is room, such a corner of it
    // is among them.
    template <typename Use>
    void walk_around(const Site& site, std::uint8_t kind, std::mt19937_64& random, Use use) const {
        if (site.shapes.empty() || factor(site.kind, kind) == 0) return;
        constexpr int kAngles = 24;
        constexpr double kStep = 2 * std::numbers::pi / kAngles;
        const double first = verify::any_in(random, 0, kStep);
        std::vector<double> before, after;
        for (int i = 0; i <= kAngles; ++i, before = after) {
            const double angle = first + i * kStep;
            after = signs_at(site, angle, kind);
            use(boundary_of(site, angle, kind), kind);
            for (std::size_t k = 0; i > 0 && k < after.size(); ++k) {
                if ((before[k] < 0) == (after[k] < 0)) continue;
                const auto [low, high] = halved(site, angle - kStep, angle, kind, k);
                use(boundary_of(site, low, kind), kind);
                use(boundary_of(site, high, kind), kind);
            }
        }
    }
    // Whether the spot at an angle is open, and for each point how far it is over its limit.
    std::vector<double> signs_at(const Site& site, double angle, std::uint8_t kind) const {
        const Point spot = wrapped(boundary_of(site, angle, kind));
        std::vector<double> signs(sites_.size() + 1, 1);
        for (std::size_t k = 0; k <= sites_.size(); ++k) signs[k] = sign_at(spot, kind, k);
        return signs;
    }
    double sign_at(Point spot, std::uint8_t kind, std::size_t k) const {
        if (k == sites_.size()) return is_open(spot) ? 1 : -1;
        const std::optional<Shape> own = domain_.contains(spot) ? shape_at(spot) : std::nullopt;
        return own ? over(sites_[k], spot, *own, kind) : 1;
    }
    std::pair<double, double> halved(const Site& site, double low, double high, std::uint8_t kind,
                                     std::size_t k) const {
        const auto is_in = [&](double angle) {
            return sign_at(wrapped(boundary_of(site, angle, kind)), kind, k) < 0;
        };
        const bool is_low_in = is_in(low);
        const int halvings = k == sites_.size() ? 20 : 40;
        for (int i = 0; i < halvings; ++i) {
            const double middle = low + (high - low) / 2;
            (is_in(middle) == is_low_in ? low : high) = middle;
        }
        return {low, high};
    }

    std::string text_of(std::size_t i) const {
        std::ostringstream out;
        out.precision(17);
        out << "point " << i << " at (" << sites_[i].at.x << ", " << sites_[i].at.y << ")";
        return out.str();
    }

    const Made& made_;
    const Request& request_;
    const verify::Domain domain_;
    const double size_;
    double least_distance_;
    std::vector<Site> sites_;
};

}  // namespace lacuna::tests

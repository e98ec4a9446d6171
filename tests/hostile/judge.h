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

#include "hostile/zones.h"

namespace lacuna::tests {

class Judge : public Zones {
public:
    using Zones::Zones;

    // What is wrong with the points; empty if nothing is.
    std::string fault() const {
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            const bool is_own = i < own_;
            if (is_own && !is_allowed(sites_[i], i < made_.keep.size()))
                return text_of(i) + " lies where no point may";
            for (std::size_t j = 0; j < std::min(i, own_); ++j)
                if (are_in_conflict(sites_[i], sites_[j]))
                    return text_of(j) + " and " + text_of(i) + " are too close";
        }
        return "";
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
            if (!is_open(spot, kind)) return;
            const double found = room(spot, kind);
            if (found > largest.room) largest = {spot, kind, found};
        };
        constexpr int kSpots = 60;
        for (std::size_t kind = 0; kind < kinds(); ++kind) {
            const std::vector<double>& weights = request_.classes.weights;
            if (!weights.empty() && weights[kind] == 0) continue;
            const auto& numbers = request_.classes.counts;
            if (!numbers.empty() && numbers[kind]) continue;
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
            std::ceil(request_.paper2011.lines_per_radius.value_or(30) * domain_.width / size_);
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
            if (!is_open(spot, kind)) continue;
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
        if (made_.avoided.empty() || !with_distances) return depth;
        const PolygonSet& lines = made_.polygons.back();
        const double beyond = std::abs(in(made_.avoided)) - lines.distance;
        return std::min(depth, lines.near ? -beyond : beyond);
    }

private:
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
        if (k == sites_.size()) return is_open(spot, kind) ? 1 : -1;
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
};

}  // namespace lacuna::tests

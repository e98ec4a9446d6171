// Where the judge looks for room: around points, at corners of what is covered, and at random.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/judge.h"

namespace lacuna::judge {

Judge::Gap Judge::largest_gap(Random& random) const {
    Gap largest;
    const Look look = [&](Point spot, std::uint8_t kind) {
        if (!is_open(spot, kind)) return;
        const double found = room(spot, kind);
        if (found > largest.room) largest = {spot, kind, found};
    };
    constexpr int kSpots = 60;
    for (std::size_t i = 0; i < kinds(); ++i) {
        const auto kind = static_cast<std::uint8_t>(i);
        if (!is_drawn(kind)) continue;
        for (int k = 0; k < kSpots; ++k) look(any_place(random, domain_), kind);
        // Many classes of many points are looked at in part.
        const std::size_t step = 1 + sites_.size() * kinds() / 400;
        for (std::size_t k = random() % step; k < sites_.size(); k += step)
            walk_around(sites_[k], kind, random, look);
    }
    return largest;
}

Judge::Gap Judge::largest_gap_near(Point place, std::uint8_t kind, Random& random) const {
    Gap largest{place, kind};
    double reach = std::max(domain_.width, domain_.height);
    for (const Shape& shape : shapes_near(place)) reach = std::min(reach, 2 * shape.longer);
    for (int i = 0; i < 3000; ++i, reach *= 0.995) {
        const Point spot = wrapped(domain_, {largest.at.x + any_in(random, -reach, reach),
                                             largest.at.y + any_in(random, -reach, reach)});
        if (!is_open(spot, kind)) continue;
        const double found = room(spot, kind);
        if (found > largest.room) largest = {spot, kind, found};
    }
    return largest;
}

Judge::Gap Judge::largest_gap_of_raster(int steps) const {
    Gap largest;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            for (std::size_t kind = 0; kind < kinds(); ++kind) {
                const Point spot{domain_.x0 + domain_.width * i / steps,
                                 domain_.y0 + domain_.height * j / steps};
                const auto of_kind = static_cast<std::uint8_t>(kind);
                if (!is_open(spot, of_kind)) continue;
                const double found = room(spot, of_kind);
                if (found > largest.room) largest = {spot, of_kind, found};
            }
    return largest;
}

double Judge::most_room_on_lines() const {
    const double lines =
        std::ceil(request_.paper2011.lines_per_radius.value_or(30) * domain_.width / size_);
    double most = -kInfinity;
    for (const Site& site : sites_) {
        const double middle = (site.at.x - domain_.x0) / domain_.width * lines;
        const double around = std::min(lines, std::ceil(size_ / domain_.width * lines) + 1);
        for (double line = std::floor(middle - around); line <= middle + around; ++line) {
            const double x = domain_.x0 + (line + 0.5) * domain_.width / lines;
            const double along =
                std::sqrt(std::max(0.0, size_ * size_ - std::pow(x - site.at.x, 2)));
            for (const double y : {site.at.y - along, site.at.y + along}) {
                const Point spot = wrapped(domain_, {x, y});
                if (along > 0 && contains(domain_, spot)) most = std::max(most, room(spot));
            }
        }
    }
    return most;
}

Point Judge::too_close_to(std::size_t i, std::uint8_t kind, Random& random) const {
    const Point on = boundary_of(sites_[i], any_in(random, 0, 7), kind);
    const Point at = sites_[i].at;
    return wrapped(domain_, {at.x + 0.99 * (on.x - at.x), at.y + 0.99 * (on.y - at.y)});
}

// The spot where a point's own zone ends in a direction, for points of a class.
Point Judge::boundary_of(const Site& site, double angle, std::uint8_t kind) const {
    const Point ahead{std::cos(angle), std::sin(angle)};
    const double f = factor(site.kind, kind);
    const Shape& own = site.shapes.front();
    double reach = f / own.length_of(ahead);
    const auto at = [&] { return Point{site.at.x + reach * ahead.x, site.at.y + reach * ahead.y}; };
    for (int i = 0; i < 3; ++i)
        if (const auto there = shape_at(wrapped(domain_, at())))
            reach = f / std::max(there->length_of(ahead), own.length_of(ahead));
    return at();
}

// Below 0 if the spot is covered by site k or, for one k more, not open.
double Judge::sign_at(Point spot, std::uint8_t kind, std::size_t k) const {
    if (k == sites_.size()) return is_open(spot, kind) ? 1 : -1;
    const std::optional<Shape> own =
        contains(domain_, spot) ? shape_at(spot) : std::optional<Shape>();
    return own ? over(sites_[k], spot, *own, kind) : 1;
}

// Spots around a point, just outside of its zone: at some angles, where the zone of another point
// begins or ends, and where the allowed part does. If there is room, such a corner of it is among
// them.
void Judge::walk_around(const Site& site, std::uint8_t kind, Random& random,
                        const Look& look) const {
    if (site.shapes.empty() || factor(site.kind, kind) == 0) return;
    constexpr int kAngles = 24;
    constexpr double kStep = 2 * std::numbers::pi / kAngles;
    const double first = any_in(random, 0, kStep);
    const auto at = [&](double angle) { return wrapped(domain_, boundary_of(site, angle, kind)); };
    std::vector<double> before, after(sites_.size() + 1);
    for (int i = 0; i <= kAngles; ++i) {
        const double angle = first + i * kStep;
        before = after;
        const Point spot = at(angle);
        for (std::size_t k = 0; k < after.size(); ++k) after[k] = sign_at(spot, kind, k);
        look(spot, kind);
        for (std::size_t k = 0; i > 0 && k < after.size(); ++k) {
            if ((before[k] < 0) == (after[k] < 0)) continue;
            double low = angle - kStep, high = angle;
            for (int halvings = k == sites_.size() ? 20 : 40; halvings != 0; --halvings) {
                const double middle = low + (high - low) / 2;
                const bool is_like_low = (sign_at(at(middle), kind, k) < 0) == (before[k] < 0);
                (is_like_low ? low : high) = middle;
            }
            look(at(low), kind);
            look(at(high), kind);
        }
    }
}

}  // namespace lacuna::judge

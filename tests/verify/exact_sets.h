// Small exact sets of every kind, and the gap that geometry finds where a point was moved.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "verify/domain.h"

namespace lacuna::verify {

inline double random_in(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

template <typename Value>
Value pick(std::mt19937_64& random, std::initializer_list<Value> values) {
    return values.begin()[random() % values.size()];
}

// A request on a box or torus, with sides of any ratio and m from 1 to 60, for one sample up to
// some hundreds. The radius may be as large as a torus's shorter side, or nearly as a box's
// diagonal.
inline Request small_exact_request(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Request request;
    request.mode = Mode::exact;
    request.place.backend = "cpu";
    request.seed = random();
    request.domain.boundary = pick(random, {Boundary::box, Boundary::torus});
    const double scale = pick(random, {1.0, 1.0, 1e-7, 3e8});
    request.domain.width = scale * pick(random, {1.0, 1.0, random_in(random, 0.2, 5)});
    request.domain.height = scale * pick(random, {1.0, 1.0, random_in(random, 0.2, 5)});
    // Some domains are strips, as narrow or as long as is allowed.
    if (random() % 20 == 0) request.domain.height = request.domain.width / 999;
    if (random() % 20 == 0) request.domain.width = request.domain.height / 999;

    const double shorter = request.domain.shorter_side();
    const double fewest =
        request.domain.wraps()
            ? shorter
            : std::hypot(request.domain.width, request.domain.height) * (1 - 1e-9);
    const double finest =
        std::max(std::sqrt(request.domain.width * request.domain.height) / 10, fewest / 1000);
    const double share = random() % 6 == 0 ? 0 : random_in(random, 0, 1);
    request.radius = std::min(fewest, fewest * std::pow(std::min(1.0, finest / fewest), share));
    request.paper2011.lines_per_radius = static_cast<std::uint32_t>(1 + random() % 60);
    request.paper2011.round_size = pick(random, {0u, 0u, 1u, 7u});
    request.place.threads = 1;
    return request;
}

inline Domain domain_of(const Request& request) {
    return {request.domain.width, request.domain.height, request.domain.wraps()};
}

// The largest gap where a point of a maximal set was moved away, computed without the search of
// verify. The spot that is farthest from all points is the centre of a circle through three points.
// On a box it may also be a corner, or a spot of an edge that is as far from one point as from
// another. Only spots within a radius of the point's old position can become free.
class Surroundings {
public:
    // `reach`: the radius plus the tolerance.
    Surroundings(const Domain& domain, std::span<const Point> points, Point was, double reach)
        : domain_(domain), was_(was), reach_(reach) {
        const int wraps = domain.torus ? 2 : 0;
        for (const Point point : points)
            for (int i = -wraps; i <= wraps; ++i)
                for (int j = -wraps; j <= wraps; ++j)
                    append_if_near({point.x + i * domain.width, point.y + j * domain.height});
    }

    // The largest distance to the nearest point.
    double gap() {
        for (std::size_t i = 0; i < near_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t k = 0; k < j; ++k) look_at_centre(near_[i], near_[j], near_[k]);
                if (!domain_.torus) look_at_edges(near_[i], near_[j]);
            }
        for (const double x : {0.0, domain_.width})
            for (const double y : {0.0, domain_.height})
                if (!domain_.torus) look_at({x, y});
        return gap_;
    }

private:
    static double between(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

    void append_if_near(Point point) {
        if (between(point, was_) < 2.2 * reach_) near_.push_back(point);
    }

    void look_at(Point place) {
        // This also refuses NaN, which is the centre of the circle through three points of a line.
        if (!(between(place, was_) < 1.05 * reach_)) return;
        const bool is_outside =
            place.x < 0 || place.x > domain_.width || place.y < 0 || place.y > domain_.height;
        if (!domain_.torus && is_outside) return;
        double nearest = between(place, near_.front());
        for (const Point point : near_) nearest = std::min(nearest, between(place, point));
        gap_ = std::max(gap_, nearest);
    }

    void look_at_centre(Point a, Point b, Point c) {
        const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
        const double twice_cross = 2 * (bx * cy - by * cx);
        const double b_squared = bx * bx + by * by, c_squared = cx * cx + cy * cy;
        look_at({a.x + (cy * b_squared - by * c_squared) / twice_cross,
                 a.y + (bx * c_squared - cx * b_squared) / twice_cross});
    }

    void look_at_edges(Point a, Point b) {
        const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
        const double slope = (b.x - a.x) / (b.y - a.y);
        for (const double x : {0.0, domain_.width}) look_at({x, middle.y - (x - middle.x) * slope});
        for (const double y : {0.0, domain_.height})
            look_at({middle.x - (y - middle.y) / slope, y});
    }

    const Domain& domain_;
    Point was_;
    double reach_;
    std::vector<Point> near_;
    double gap_ = 0;
};

}  // namespace lacuna::verify

// Polygons of every hostile kind: with holes, slivers and needles, crossing themselves and each
// other, narrower than a pixel of their mask, with edges on the middles and borders of its pixels.
#pragma once

#include <lacuna/domains.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "judge/judge.h"

namespace lacuna::tests {

using Rings = std::vector<PolygonRing>;

inline PolygonRing rectangle(Point low, Point high) {
    return {{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}};
}

// A star of five points that crosses itself, whose middle is a hole.
inline PolygonRing pentagram(Point middle, double reach, double turn) {
    PolygonRing ring;
    for (int i = 0; i < 5; ++i) {
        const double angle = turn + 2 * i * (2 * std::numbers::pi / 5);
        ring.push_back({middle.x + reach * std::cos(angle), middle.y + reach * std::sin(angle)});
    }
    return ring;
}

// Teeth that become narrower, from wider than a pixel to far narrower than one.
// A domain without room for a tooth has a triangle.
inline PolygonRing comb(const Domain& domain, double edge) {
    PolygonRing ring{{domain.width, 0}, {0, 0}, {0, domain.height * 0.05}};
    double x = 0;
    for (double tooth = 12 * edge; x + tooth < domain.width && tooth > edge / 1000; tooth *= 0.8) {
        ring.push_back({x, domain.height * 0.95});
        ring.push_back({x + tooth, domain.height * 0.95});
        ring.push_back({x + tooth, domain.height * 0.05});
        ring.push_back({x += 2 * tooth, domain.height * 0.05});
    }
    return ring;
}

// An island of irregular outline, perhaps with a lake, and perhaps a thin triangle across both.
inline Rings any_rings(std::mt19937_64& random, const Domain& domain) {
    const Point middle{domain.width * judge::any_in(random, 0.3, 0.7),
                       domain.height * judge::any_in(random, 0.3, 0.7)};
    const auto star = [&](double least, double most) {
        PolygonRing ring;
        for (int i = 0; i < 12; ++i) {
            const double reach = judge::any_in(random, least, most);
            ring.push_back({middle.x + domain.width * reach * std::cos(i * 0.5236),
                            middle.y + domain.height * reach * std::sin(i * 0.5236)});
        }
        return ring;
    };
    Rings rings{star(0.25, 0.7)};
    if (random() % 2 == 0) rings.push_back(star(0.02, 0.2));
    if (random() % 2 == 0)
        rings.push_back({{0, middle.y},
                         {domain.width, middle.y * (1 + 1e-7)},
                         {domain.width, middle.y * (1 - 1e-7)}});
    return rings;
}

// For a mask where half the diagonal of a pixel is `edge`.
class RandomPolygons {
public:
    RandomPolygons(std::mt19937_64& random, const Domain& domain, double edge)
        : random_(random), domain_(domain), edge_(edge), longer_(domain.longer_side()) {}

    Rings next() {
        switch (below(10)) {
            case 0:  // an island with a lake
                return any_rings(random_, domain_);
            case 1:
                return {
                    pentagram({domain_.width / 2, domain_.height / 2}, shorter() * 0.49, in(0, 7))};
            case 2:
                return {comb(domain_, edge_)};
            case 3:  // that overlap
                return some(2, 20, [&] { return box_of(place(), place()); });
            case 4:
                return some(1, 12, [&] { return needle(); });
            case 5:
                return holes();
            case 6:
                return some(1, 6, [&] { return box_of(place_on_lattice(), place_on_lattice()); });
            case 7:
                return nothings();
            case 8:
                return neighbours();
            default:
                return some(1, 60, [&] { return crumb(); });
        }
    }

private:
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    double in(double low, double high) { return judge::any_in(random_, low, high); }
    Point place() { return judge::any_place(random_, domain_); }
    double shorter() const { return std::min(domain_.width, domain_.height); }
    PolygonRing all() const { return rectangle({-longer_, -longer_}, {2 * longer_, 2 * longer_}); }

    template <typename Make>
    Rings some(std::uint32_t least, std::uint32_t more, Make make) {
        Rings rings(least + below(more));
        for (PolygonRing& ring : rings) ring = make();
        return rings;
    }

    static PolygonRing box_of(Point a, Point b) {
        return rectangle({std::min(a.x, b.x), std::min(a.y, b.y)},
                         {std::max(a.x, b.x), std::max(a.y, b.y)});
    }

    // A point at the middle or on the border of one of the mask's pixels.
    Point place_on_lattice() {
        const auto along = [&](double side) {
            const double pixels = std::max(1.0, std::ceil(side / (edge_ * std::sqrt(2.0))));
            return side * below(2 * static_cast<std::uint32_t>(pixels) + 1) / (2 * pixels);
        };
        const double x = along(domain_.width);
        return {x, along(domain_.height)};
    }

    PolygonRing needle() {
        const Point a = place(), b = place();
        const double width = longer_ * (below(2) == 0 ? 1 : std::pow(10, in(-9, -1)));
        return {a, b, {b.x + width, b.y + width / 3}};
    }

    // A rectangle hardly larger than a pixel.
    PolygonRing crumb() {
        const Point a = place();
        const double size = edge_ * in(0.5, 6);
        return rectangle(a, {a.x + size, a.y + size * in(0.1, 3)});
    }

    // All but holes that reach out of the domain.
    Rings holes() {
        Rings rings = some(1, 4, [&] { return pentagram(place(), shorter() * in(0.1, 2), 1); });
        rings.push_back(all());
        return rings;
    }

    // A box that is a hole three times, so it stays a hole, and rings that enclose no area.
    Rings nothings() {
        const PolygonRing box = box_of(place(), place());
        const Point a = place(), b = place();
        const Point between{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
        return {all(), box, box, box, {a, b, a}, {a, b, between}, {a, a, a}};
    }

    // Boxes with an edge or a corner in common.
    Rings neighbours() {
        const Point a = place();
        return {rectangle({0, 0}, a), rectangle(a, {domain_.width, domain_.height}),
                rectangle({a.x, 0}, {domain_.width, a.y})};
    }

    std::mt19937_64& random_;
    const Domain domain_;
    double edge_;
    double longer_;
};

}  // namespace lacuna::tests

// Masks beside outlines: points lie where both allow them, and fill it.
#include "places/mask_outlines.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/places.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace lacuna {
namespace {

constexpr double kRadius = 0.03, kEdge = kRadius / 16;
const PolygonRing kTriangle{{2, 5}, {3, 5}, {2.5, 6}};

Mask random_mask(std::mt19937_64& random, std::uint32_t columns, std::uint32_t rows) {
    Mask mask{columns, rows, std::vector<std::uint8_t>(columns * rows), {}, {}};
    for (std::uint8_t& one : mask.allowed) one = random() % 3 != 0;
    return mask;
}

// How far a point is from where it may not lie: below 0 if it lies there.
double clearance(Point at, const Mask& mask, const Domain& domain) {
    double least = INFINITY;
    for (std::size_t i = 0; i < kTriangle.size(); ++i) {
        const Point a = kTriangle[i], b = kTriangle[(i + 1) % kTriangle.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        least = std::min(least, ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length);
    }
    const double across = domain.width / mask.columns, up = domain.height / mask.rows;
    for (std::uint32_t row = 0; row < mask.rows; ++row)
        for (std::uint32_t column = 0; column < mask.columns; ++column) {
            if (mask.allowed[row * mask.columns + column] != 0) continue;
            const double dx = std::abs(at.x - domain.x0 - (column + 0.5) * across) - across / 2;
            const double dy = std::abs(at.y - domain.y0 - (mask.rows - row - 0.5) * up) - up / 2;
            const double apart = std::hypot(std::max(dx, 0.), std::max(dy, 0.));
            least = std::min(least, dx < 0 && dy < 0 ? std::max(dx, dy) : apart);
        }
    return least;
}

TEST(AMaskBesideOutlines, IsKeptFromAndFilledUpTo) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit;
    for (const std::uint32_t size : {1U, 2U, 3U, 5U, 8U, 13U}) {
        const Domain domain{.width = 1, .height = 1, .x0 = 2, .y0 = 5};
        const Mask mask = random_mask(random, size, size + size / 2);
        Request request{.domain = domain, .radius = kRadius, .seed = size};
        request.places.mask = &mask;
        request.places.outlines = {{{.rings = {kTriangle}}, Role::inside, {}, {}, false}};
        const Result set = sample(request);
        for (const Point& point : set.points) EXPECT_GE(clearance(point, mask, domain), 0);
        for (int i = 0; i < 4000; ++i) {
            const Point spot{2 + unit(random), 5 + unit(random)};
            if (clearance(spot, mask, domain) <= kEdge) continue;
            EXPECT_TRUE(std::any_of(set.points.begin(), set.points.end(),
                                    [&](Point point) {
                                        return std::hypot(point.x - spot.x, point.y - spot.y) <
                                               kRadius;
                                    }))
                << spot.x << " " << spot.y << " of " << size;
        }
        Claim claim = claim_of(request, set);
        EXPECT_TRUE(prove(set.points, claim).maximal) << size;
        if (set.points.empty()) continue;
        EXPECT_FALSE(prove(std::span(set.points).subspan(1), claim).covered) << size;
        // Without the mask there is room on its dark pixels.
        claim.places.mask = nullptr;
        EXPECT_TRUE(size < 5 || !prove(set.points, claim).covered) << size;
    }
}

// The pixels of one class alone, and those of all others.
TEST(AMaskBesideOutlines, MayBeOfAClassOfSeveralSizes) {
    Mask left{2, 1, {1, 0}, {}, {}}, right{2, 1, {0, 1}, {}, {}};
    const std::vector<PolygonRing> hole{{{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}};
    Request request{.seed = 3};
    request.classes.names = {"trees", "trees", "grass"};
    const std::vector<double> radii{0.03, 0.04, 0.01};
    request.classes.distances = distances_by_sum(radii);
    request.places.mask = &right;
    request.places.masks = {&left, &left, nullptr};
    request.places.outlines = {{{.rings = hole}, Role::outside, {}, {}, false}};
    const Result set = sample(request);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        EXPECT_EQ(set.points[i].x < 0.5, set.classes[i] < 2);
        EXPECT_FALSE(std::max(std::abs(set.points[i].x - 0.5), std::abs(set.points[i].y - 0.5)) <
                     0.1);
    }
    EXPECT_TRUE(prove(set.points, claim_of(request, set)).maximal);
    // An outline is for all sizes, and each class must have a name.
    request.places.masks = {&left, &right, nullptr};
    EXPECT_THROW(sample(request), BadRequest);
    Request nameless = request;
    nameless.classes = {};
    nameless.radius = 0.05;
    EXPECT_THROW(sample(nameless), BadRequest);
    // What was drawn from polygons has no pixels to go around.
    const PolygonSet around{hole};
    const Mask drawn = draw_places({&around, 1}, {}, 0.01);
    request.places.masks.clear();
    request.places.mask = &drawn;
    EXPECT_THROW(sample(request), BadRequest);
}

}  // namespace
}  // namespace lacuna

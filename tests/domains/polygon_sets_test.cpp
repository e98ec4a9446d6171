// Several sets of polygons: where samples may lie, drawn onto a mask and proven from coordinates.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "domains/picture_of_mask.h"
#include "judge/places_of.h"

namespace lacuna {
namespace polygon_sets_test {

PolygonRing rectangle(double left, double right, double bottom, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

constexpr double kPixel = 1.41422;  // the diagonal of a pixel of side 1

TEST(SetsOfPolygons, AreJoinedAndTheForbiddenTakenAway) {
    const std::vector<PolygonRing> low{rectangle(-0.1, 4.1, -0.1, 3.1)};
    const std::vector<PolygonRing> high{rectangle(1.9, 6.1, 1.9, 5.1),
                                        rectangle(4.1, 4.9, 3.1, 3.9)};
    const std::vector<PolygonRing> gone{rectangle(1.1, 2.9, 1.1, 3.9)};
    EXPECT_EQ(tests::picture_of(draw_mask(std::vector<PolygonSet>{{low}, {high}}, {6, 5}, kPixel)),
              "..####\n"
              "..##.#\n"
              "######\n"
              "####..\n"
              "####..\n");
    const std::string left =
        "..####\n"
        "...#.#\n"
        "#..###\n"
        "#..#..\n"
        "####..\n";
    EXPECT_EQ(tests::picture_of(draw_mask(
                  std::vector<PolygonSet>{{low}, {high}, {gone, Role::outside}}, {6, 5}, kPixel)),
              left);
    EXPECT_EQ(tests::picture_of(draw_mask(
                  std::vector<PolygonSet>{{gone, Role::outside}, {high}, {low}}, {6, 5}, kPixel)),
              left);
    EXPECT_EQ(tests::picture_of(
                  draw_mask(std::vector<PolygonSet>{{gone, Role::outside}}, {3, 2}, kPixel)),
              "#..\n"
              "###\n");
}

TEST(SetsOfPolygons, WithoutFiniteCornersAreRefused) {
    const std::vector<PolygonRing> all{rectangle(0, 1, 0, 1)};
    const std::vector<PolygonRing> broken{{{0, 0}, {1, 0}, {std::nan(""), 1}}};
    try {
        draw_mask(std::vector<PolygonSet>{{all}, {broken, Role::outside}}, {1, 1}, 0.1);
        FAIL();
    } catch (const BadRequest& error) {
        EXPECT_TRUE(std::string_view(error.what()).starts_with("outside ring 0"));
    }
}

// Triangles and rectangles, turned, that overlap at random, on a domain of 1 x 1.
std::vector<PolygonRing> random_rings(std::mt19937_64& random, const Domain& domain) {
    std::uniform_real_distribution<double> unit;
    const std::size_t corners = 3 + random() % 2;
    const double x = unit(random), y = unit(random), size = 0.15 + 0.4 * unit(random);
    const double turn = 7 * unit(random);
    PolygonRing ring;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle =
            turn + 6.2831853 * static_cast<double>(i) / static_cast<double>(corners);
        ring.push_back(domain.at({x + size * std::cos(angle), y + size * std::sin(angle)}));
    }
    return {ring};
}

// Whether all pixels of the mask around a point are allowed.
bool is_deep_inside(const Mask& mask, const Domain& domain, Point place) {
    const Point point = domain.from_corner(place);
    const auto column = static_cast<std::int64_t>(point.x * mask.columns);
    const auto row = static_cast<std::int64_t>((1 - point.y) * mask.rows);
    for (std::int64_t dy = -2; dy <= 2; ++dy)
        for (std::int64_t dx = -2; dx <= 2; ++dx) {
            const std::int64_t x = column + dx, y = row + dy;
            if (x < 0 || y < 0 || x >= mask.columns || y >= mask.rows) return false;
            if (mask.allowed[static_cast<std::size_t>(y) * mask.columns +
                             static_cast<std::size_t>(x)] == 0)
                return false;
        }
    return true;
}

TEST(SetsOfPolygons, AreFilledAndProvenFull) {
    std::mt19937_64 random(7);
    int refuted = 0;
    for (int i = 0; i < 120; ++i) {
        std::vector<std::vector<PolygonRing>> rings;
        std::vector<PolygonSet> sets;
        const std::size_t allowed = random() % 4, forbidden = allowed == 0 ? 1 : random() % 3;
        Request request;
        request.domain.x0 = std::array{0.0, 448000.0, -1 / 3.0, -1048576.0}[random() % 4];
        request.domain.y0 = std::array{0.0, -541100.1, 1e-9, 1048576.0}[random() % 4];
        for (std::size_t k = 0; k < allowed + forbidden; ++k)
            rings.push_back(random_rings(random, request.domain));
        for (std::size_t k = 0; k < rings.size(); ++k)
            sets.push_back({rings[k], k < allowed ? Role::inside : Role::outside});
        request.radius = 0.06;
        request.seed = static_cast<std::uint64_t>(i);
        const double edge = *request.radius / 16;
        Mask mask;
        try {
            mask = draw_mask(sets, request.domain, edge);
        } catch (const BadRequest&) {
            continue;
        }
        request.places.mask = &mask;
        std::vector<Point> points = sample(request).points;
        Claim claim;
        claim.radius = *request.radius;
        claim.domain = request.domain;
        claim.places = tests::places_of(sets, edge);
        const Proof proof = prove(points, claim);
        ASSERT_TRUE(proof.maximal) << "case " << i << ", " << points.size() << " points, gap at "
                                   << proof.largest_gap.x << " " << proof.largest_gap.y;
        const auto deep = std::find_if(points.begin(), points.end(), [&](Point point) {
            return is_deep_inside(mask, request.domain, point);
        });
        if (deep == points.end()) continue;
        points.erase(deep);
        EXPECT_FALSE(prove(points, claim).covered) << "case " << i;
        ++refuted;
    }
    EXPECT_GE(refuted, 90);
}

// The centre decides, however coarse the drawn mask is.
TEST(SetsOfPolygons, HaveTheSamplesOfPixelsWhoseCentresLieInThem) {
    const std::vector<PolygonRing> triangle{{{5, 5}, {55.5, 5}, {5, 55.5}}};
    const PolygonSet set{.rings = triangle};
    Request request;
    request.domain = {60, 60};
    request.mode = Mode::pixels;
    request.on_pixels = {60, 60};
    request.count = 1275;  // 50 + 49 + ... + 1 centres
    const Mask mask = draw_places({&set, 1}, request.domain, 1);
    request.places.mask = &mask;
    for (const Point& point : sample(request).points)
        EXPECT_TRUE(point.x > 5 && point.y > 5 && point.x + point.y < 60.5);
    request.count = 1276;
    EXPECT_THROW(sample(request), BadRequest);
}

// The field is 0 at the middles of all pixels of the drawn mask, which is coarser.
TEST(SetsOfPolygons, HaveACountOnAFieldThatIsFinerThanTheirMask) {
    const std::vector<PolygonRing> small{rectangle(0.49, 0.51, 0.49, 0.51)};
    const PolygonSet set{.rings = small, .role = Role::outside};
    const Field field{9, 1, {1, 0, 0, 0, 0, 0, 0, 0, 0}};
    Request request;
    const Mask mask = draw_places({&set, 1}, request.domain, 0.4);
    ASSERT_LT(mask.columns, 9U);
    request.field = &field;
    request.places.mask = &mask;
    request.count = 50;
    const std::vector<Point> points = sample(request).points;
    EXPECT_EQ(points.size(), 50U);
    for (const Point& point : points) EXPECT_LT(point.x, 1.0 / 9 + 1e-8);
}

// Two rings that overlap only around the torus: a place in both is not outside.
TEST(Obstacles, WhoseImagesOverlapAroundATorusCloseAllOfBoth) {
    Request request{.domain = {.boundary = Boundary::torus}, .radius = 0.03};
    request.places.outlines = {
        {.polygons = {{rectangle(-0.1, 0.1, 0.4, 0.6), rectangle(0.94, 1.06, 0.45, 0.55)}, {}},
         .role = Role::avoid,
         .distance = 0.02}};
    const Result set = sample(request);
    for (const Point& point : set.points)
        EXPECT_FALSE((point.x < 0.12 || point.x > 0.88) && point.y > 0.4 && point.y < 0.6);
    EXPECT_TRUE(prove(set.points, claim_of(request, set)).maximal);
}

}  // namespace polygon_sets_test
}  // namespace lacuna

// Sets in space are proven or refuted: as brute force finds, and as is known of simple ones.
#include <lacuna/space.h>

#include <gtest/gtest.h>
#include <lacuna/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "refusal.h"

namespace space_test {

using namespace lacuna;
using Points = std::vector<Point3>;

double distance_of(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// A height field over the unit square, with a triangle without area, one that is there twice, one
// that crosses others, and a vertex that no triangle has.
Mesh hills(std::uint32_t sides) {
    Mesh mesh{{{0.3, 0.2, 9}}, {{1, 1, 2}, {1, 2, sides + 3}, {1, 2, 3 * sides}}};
    for (std::uint32_t at = 0; at < (sides + 1) * (sides + 1); ++at) {
        const std::uint32_t i = at % (sides + 1), j = at / (sides + 1);
        const double x = double(i) / sides, y = double(j) / sides;
        mesh.vertices.push_back({x, y, 0.1 * std::sin(7 * x) * std::cos(5 * y)});
        if (i == sides || j == sides) continue;
        mesh.triangles.push_back({at + 1, at + 2, at + sides + 3});
        mesh.triangles.push_back({at + 1, at + sides + 3, at + sides + 2});
    }
    return mesh;
}

// Adds the largest gap until there is none.
Points filled(const SpaceClaim& claim, Points points) {
    for (SpaceProof proof = prove(points, claim); !proof.covered; proof = prove(points, claim))
        points.push_back(proof.largest_gap);
    return points;
}

Point3 any_spot(const Mesh& mesh, std::mt19937& random) {
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    const double u = double(random()) * 0x1p-32, v = (1 - u) * double(random()) * 0x1p-32;
    const Point3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                 &c = mesh.vertices[triangle[2]];
    return {a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y),
            a.z + u * (b.z - a.z) + v * (c.z - a.z)};
}

// Products of the lengths of its sides have too few digits to say which side of an edge a point is
// on.
TEST(SetsOnAMesh, OfThinTrianglesFarFromZeroLieOnThem) {
    const Mesh ribbon{{{-5000, -5000, 0}, {-4999, -4999.9, 0.2}, {-4999, -4999.899983, 0.2}},
                      {{0, 1, 2}}};
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const Points points{any_spot(ribbon, random)};
        const SpaceClaim claim{.mesh = &ribbon, .radius = 2, .distances_only = true};
        EXPECT_FALSE(prove(points, claim).outside) << i;
    }
}

TEST(SetsOnAMesh, AreAsBruteForceFinds) {
    for (const std::uint32_t sides : {2U, 40U}) {  // triangles larger and smaller than the radius
        const Mesh mesh = hills(sides);
        const SpaceClaim claim{.mesh = &mesh, .radius = 0.11};
        Points points = filled(claim, {mesh.vertices[1]});
        const SpaceProof proof = prove(points, claim);
        EXPECT_TRUE(proof.maximal);
        std::mt19937 random(sides);
        const auto nearest = [&](const Point3& spot) {
            double least = std::numeric_limits<double>::infinity();
            for (const Point3& point : points)
                if (!(point == spot)) least = std::min(least, distance_of(point, spot));
            return least;
        };
        EXPECT_NEAR(nearest(proof.largest_gap), proof.largest_gap_distance, 1e-15);
        EXPECT_NEAR(nearest(points[proof.first]), proof.least_distance, 1e-15);
        for (const Point3& point : points) EXPECT_GE(nearest(point), proof.least_distance - 1e-15);
        for (int i = 0; i < 20000; ++i)
            EXPECT_LE(nearest(any_spot(mesh, random)), proof.largest_gap_distance + 1e-4);

        const Point3 gone = points[points.size() / 2];
        points.erase(points.begin() + long(points.size() / 2));
        const SpaceProof without = prove(points, claim);
        EXPECT_TRUE(without.kept && !without.covered && !without.maximal);
        EXPECT_LT(distance_of(without.largest_gap, gone), 0.11);
        points.push_back(any_spot(mesh, random));
        EXPECT_FALSE(prove(filled(claim, points), {.mesh = &mesh, .radius = 0.2}).kept);
        points.back().z += 1e-7;
        EXPECT_EQ(prove(points, claim).outside, points.size() - 1);
    }
}

TEST(SetsInAVolume, HaveTheGapsThatAreKnown) {
    const Points corners{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0},
                         {0, 0, 2}, {1, 0, 2}, {0, 2, 2}, {1, 2, 2}};
    const SpaceProof proof = prove(corners, {.volume = {1, 2, 2}, .radius = 1});
    EXPECT_TRUE(proof.kept && !proof.covered);
    EXPECT_EQ(proof.least_distance, 1);
    EXPECT_NEAR(proof.largest_gap_distance, 1.5, 1e-3);
    EXPECT_LT(distance_of(proof.largest_gap, {0.5, 1, 1}), 1e-3);
    EXPECT_TRUE(prove(corners, {.volume = {1, 2, 2}, .radius = 1.5}).covered);
    EXPECT_EQ(prove(corners, {.volume = {1, 2, 1.9}, .radius = 1}).outside, 4U);
    const Volume torus{1, 2, 2, Boundary::torus};
    const SpaceProof around =
        prove(Points{{0.9, 0.1, 1}, {0.1, 0.1, 1}}, {.volume = torus, .radius = 0.2});
    EXPECT_NEAR(around.least_distance, 0.2, 1e-15);
    EXPECT_NEAR(around.largest_gap_distance, std::hypot(0.4, 1, 1), 2e-3);
    EXPECT_EQ(prove(Points{{1, 0, 0}}, {.volume = torus, .radius = 1}).outside, 0U);
    EXPECT_TRUE(std::isinf(prove(Points{}, {.radius = 1}).largest_gap_distance));
}

TEST(ClaimsInSpace, ThatMakeNoSenseAreRefused) {
    Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const Mesh none;
    const auto refusal = [&](const SpaceClaim& claim, const Points& points) {
        return tests::refusal_of([&] { prove(points, claim); }).substr(0, 14);
    };
    EXPECT_EQ(refusal({.mesh = &mesh}, {}), "radius 0: must");
    EXPECT_EQ(refusal({.volume = {1, NAN, 1}, .radius = 1}, {}), "domain 1xnanx1");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1}, {{0, 0, 0}, {0, NAN, 0}}), "points point 1");
    mesh.triangles.push_back({0, 3, 1});
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1}, {}), "mesh triangle ");
    mesh.vertices[1].x = NAN;
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1}, {}), "mesh vertex 1:");
    EXPECT_EQ(refusal({.mesh = &none, .radius = 1}, {}), "mesh without t");
    EXPECT_THROW(prove(Points{{0.5, 0.5, 0.5}}, {.radius = 0.3}, [] { return false; }), Cancelled);
}

}  // namespace space_test

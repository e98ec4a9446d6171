// Sets on surfaces and in volumes are maximal, and have the density that is known.
// hostile/in_space.h has what random requests promise on every backend.
#include <lacuna/space.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "refusal.h"
#include "space/meshes.h"

namespace sets_in_space {

using namespace lacuna;
using tests::area_of;
using tests::distance_of;

SpaceResult made(const SpaceRequest& request) {
    return request.mesh != nullptr ? sample_surface(request) : sample_volume(request);
}

SpaceProof proof_of(const SpaceRequest& request, const SpaceResult& set) {
    return prove(set.points,
                 {.mesh = request.mesh, .volume = request.volume, .radius = set.radius});
}

// N r^2 over the area, and N r^3 over the volume. The standard deviation of a count is about a
// quarter of its root: here .0013 and .0014.
TEST(SetsInSpace, HaveTheDensityOfRandomSequentialAdsorption) {
    for (const auto& [sides, radius] : {std::pair(16U, 0.02), {300U, 0.02}}) {
        const Mesh mesh = tests::sphere(sides);
        const SpaceRequest request{.mesh = &mesh, .radius = radius, .seed = sides};
        const SpaceResult set = made(request);
        const double density =
            static_cast<double>(set.points.size()) * radius * radius / area_of(mesh);
        EXPECT_NEAR(density, 0.6966, 0.0025) << sides;
        EXPECT_TRUE(proof_of(request, set).maximal);
    }
    SpaceRequest torus{.radius = 0.03, .seed = 5};
    torus.volume.boundary = Boundary::torus;
    const SpaceResult set = made(torus);
    EXPECT_NEAR(static_cast<double>(set.points.size()) * 0.03 * 0.03 * 0.03, 0.7336, 0.005);
    EXPECT_TRUE(proof_of(torus, set).maximal);
}

// A square that is cut into one large triangle and many small and thin ones: points know nothing of
// it. The standard deviation of a share of the points is at most that of independent ones.
TEST(SetsInSpace, AreAsDenseOnSmallTrianglesAsOnLargeOnes) {
    Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    constexpr std::uint32_t kParts = 4000;
    for (std::uint32_t i = 0; i <= kParts; ++i)
        mesh.vertices.push_back({static_cast<double>(i) / kParts, 1, 0});
    for (std::uint32_t i = 0; i < kParts; ++i) mesh.triangles.push_back({0, i + 4, i + 5});
    std::array<double, 2> counts{};
    for (std::uint64_t seed = 0; seed < 3; ++seed)
        for (const std::uint32_t triangle :
             made({.mesh = &mesh, .radius = 0.03, .seed = seed}).triangles)
            ++counts[triangle == 0 ? 0 : 1];
    EXPECT_NEAR(counts[0] / (counts[0] + counts[1]), 0.5,
                3 * 0.5 / std::sqrt(counts[0] + counts[1]));
}

// Darts that are thrown at random until none has found room for long, which a proof then shows.
std::size_t darts(const Mesh& mesh, double radius, std::mt19937_64& random) {
    std::vector<double> ends;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        ends.push_back((ends.empty() ? 0 : ends.back()) + area_of(mesh, i));
    const auto number = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    std::vector<Point3> points;
    for (std::size_t misses = 0; misses < 20000; ++misses) {
        const auto end = std::lower_bound(ends.begin(), ends.end(), number() * ends.back());
        const auto& [i, j, k] = mesh.triangles[static_cast<std::size_t>(end - ends.begin())];
        double u = number(), v = number();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Point3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        const Point3 dart{a.x + u * (b.x - a.x) + v * (c.x - a.x),
                          a.y + u * (b.y - a.y) + v * (c.y - a.y),
                          a.z + u * (b.z - a.z) + v * (c.z - a.z)};
        const auto is_close = [&](const Point3& one) { return distance_of(one, dart) < radius; };
        if (std::any_of(points.begin(), points.end(), is_close)) continue;
        points.push_back(dart);
        misses = 0;
    }
    return points.size();
}

TEST(SetsInSpace, HaveAsManyPointsAsDartThrowing) {
    // Two sides of a box: an edge, corners, and an inner edge where distances go through space.
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 0.7, 0}, {0, 0.7, 0}, {0, 0, 0.5}, {1, 0, 0.5}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}}};
    constexpr double kRadius = 0.25;
    constexpr int kSets = 400;
    std::mt19937_64 random(3);
    double thrown = 0, ours = 0, squares = 0;
    for (std::uint64_t seed = 0; seed < kSets; ++seed) {
        const auto count = static_cast<double>(darts(mesh, kRadius, random));
        thrown += count;
        squares += count * count;
        ours += static_cast<double>(
            made({.mesh = &mesh, .radius = kRadius, .seed = seed}).points.size());
    }
    const double variance = squares / kSets - thrown / kSets * (thrown / kSets);
    EXPECT_NEAR(ours / kSets, thrown / kSets, 4 * std::sqrt(2 * variance / kSets));
}

// The number of points goes by the length of the ribbon, not by its area.
TEST(SetsInSpace, OfACountOnARibbonAreSpreadOverAllOfIt) {
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {0, 1e-4, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    const SpaceResult set = made({.mesh = &mesh, .count = 50, .seed = 1});
    EXPECT_EQ(set.points.size(), 50u);
    EXPECT_GT(set.radius, 0.01);  // 0.7476 of the length over the count, for cars on a street
    EXPECT_LT(set.radius, 0.0151);
}

TEST(SetsInSpace, SayWhereTheirPointsLieOnTheMesh) {
    const Mesh mesh = tests::soup(30, 4);
    std::vector<std::uint8_t> allowed(mesh.triangles.size(), 1);
    allowed[0] = allowed[3] = 0;
    const SpaceResult set = made({.mesh = &mesh, .radius = 0.02, .allowed = allowed});
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        EXPECT_NE(allowed[set.triangles[i]], 0);
        Point3 at{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double share = set.shares[i][corner];
            EXPECT_GE(share, -1e-15);
            const Point3& vertex = mesh.vertices[mesh.triangles[set.triangles[i]][corner]];
            at = {at.x + share * vertex.x, at.y + share * vertex.y, at.z + share * vertex.z};
        }
        EXPECT_LT(distance_of(at, set.points[i]), 0x1p-28);
    }
    for (const Point3& normal : normals_of(tests::sphere(8), std::vector<std::uint32_t>{41, 60}))
        EXPECT_NEAR(distance_of(normal, {}), 1, 1e-15);
}

TEST(RequestsInSpace, ThatMakeNoSenseAreRefused) {
    const Mesh mesh = tests::sphere(4);
    const std::vector<std::uint8_t> none(mesh.triangles.size());
    const std::vector<Point3> close{{1, 0, 0}, {1, 0, 0.01}}, far{{9, 0, 0}};
    const auto refusal = [](const SpaceRequest& request) {
        const std::string said = tests::refusal_of([&] { made(request); });
        return said.substr(0, said.find(':'));
    };
    EXPECT_EQ(refusal({.mesh = &mesh}), "radius missing");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1, .count = 2}), "radius with a count");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = -1}), "radius -1");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1e-9}), "radius 1e-09");
    const Mesh line{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}};
    EXPECT_EQ(refusal({.mesh = &line, .count = 5}), "count 5");
    EXPECT_EQ(refusal({.mesh = &mesh, .count = 1, .keep = close}), "count 1");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1, .allowed = none}), "allowed no triangle");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1, .keep = close}),
              "keep points that are closer than 1");
    EXPECT_EQ(refusal({.mesh = &mesh, .radius = 1, .keep = far}), "keep point 0");
    EXPECT_EQ(refusal({.volume = {1, 1, 0.5, Boundary::torus}, .radius = 0.6}), "radius 0.6");
    EXPECT_EQ(refusal({.volume = {1, 2000, 1}, .radius = 0.1}), "domain 1x2000x1");
    EXPECT_EQ(refusal({.radius = 0.00001}), "radius 1e-05");
    EXPECT_EQ(refusal({.radius = 0.1, .run_on = {.backend = "none"}}), "backend none");
    EXPECT_EQ(refusal({.radius = 0.1, .run_on = {.threads = 1025}}), "threads 1025");
    EXPECT_EQ(refusal({.radius = 0.1, .run_on = {.device = "PoCL"}}), "device PoCL");
}

}  // namespace sets_in_space

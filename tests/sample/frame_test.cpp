// Tiles with one frame: any two fit side by side.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "backends/radius_field_requests.h"
#include "refusal.h"

namespace frame_test {

using namespace lacuna;

Request tile_of(double radius) {
    Request request;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    request.place.backend = "cpu";
    return request;
}

std::vector<Result> tiles_of(Request request, double width, std::size_t count) {
    const TileFrame frame = frame_of(request, width);
    request.keep = frame.points;
    request.keep_classes = frame.classes;
    std::vector<std::uint64_t> seeds(count);
    std::iota(seeds.begin(), seeds.end(), std::uint64_t{0});
    std::vector<Result> tiles;
    sample_many(request, seeds, [&](std::uint64_t, Result tile) {
        EXPECT_TRUE(tile.maximal);
        EXPECT_TRUE(std::equal(frame.points.begin(), frame.points.end(), tile.points.begin()));
        tiles.push_back(std::move(tile));
    });
    return tiles;
}

// Tiles in a grid of columns x rows, in random order.
struct Plane {
    std::vector<Point> points;
    std::vector<std::uint8_t> classes;

    Plane(const std::vector<Result>& tiles, int columns, int rows, std::uint64_t seed) {
        std::mt19937_64 random(seed);
        for (int i = 0; i < columns * rows; ++i) {
            const Result& tile = tiles[random() % tiles.size()];
            for (const Point& at : tile.points)
                points.push_back({at.x + i % columns, at.y + i / columns});
            classes.insert(classes.end(), tile.classes.begin(), tile.classes.end());
        }
    }

    // The claim for what lies at least `ring` inside of the plane: the rest are its neighbours.
    Proof prove_inside(Claim claim, int columns, int rows, double ring) const {
        claim.domain = {columns - 2 * ring, rows - 2 * ring, Boundary::box, ring, ring};
        std::vector<Point> inside, outside;
        std::vector<std::uint8_t> of_inside, of_outside;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool is_inside = claim.domain.holds(points[i]);
            (is_inside ? inside : outside).push_back(points[i]);
            if (!classes.empty()) (is_inside ? of_inside : of_outside).push_back(classes[i]);
        }
        claim.keep = outside;
        claim.keep_classes = of_outside;
        claim.class_of_points = of_inside;
        return prove(inside, claim);
    }
};

TEST(Tiles, OfOneFrameFitInAnyOrderHoweverMany) {
    constexpr double kRadius = 0.06;
    const std::vector<Result> tiles = tiles_of(tile_of(kRadius), 1.5 * kRadius, 200);
    for (std::size_t i = 1; i < tiles.size(); ++i) EXPECT_NE(tiles[i].points, tiles[0].points);
    // Each of the 200 lies somewhere: a grid of 20 x 10 in random order, and four more.
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        const Plane plane(tiles, 20, 10, seed);
        Claim claim;
        claim.radius = kRadius;
        const Proof proof = plane.prove_inside(claim, 20, 10, kRadius);
        EXPECT_TRUE(proof.maximal) << proof.least_distance << ", " << proof.largest_gap_distance;
    }
}

TEST(Tiles, FitByAUsersComputationToo) {
    constexpr double kRadius = 0.15;
    const std::vector<Result> tiles = tiles_of(tile_of(kRadius), 1.5 * kRadius, 50);
    const Plane plane(tiles, 6, 5, 9);
    std::size_t conflicts = 0, gaps = 0;
    for (std::size_t i = 0; i < plane.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double dx = plane.points[i].x - plane.points[j].x;
            const double dy = plane.points[i].y - plane.points[j].y;
            conflicts += dx * dx + dy * dy < kRadius * kRadius * (1 - 1e-12);
        }
    std::mt19937_64 random(4);
    for (int k = 0; k < 5000; ++k) {
        // Spots near the seams.
        const double along = 1 + std::uniform_real_distribution<double>(0, 3)(random);
        const double beside = std::uniform_real_distribution<double>(-0.2, 0.2)(random);
        const double seam = 1 + static_cast<double>(random() % 4) + beside;
        const Point spot = k % 2 == 0 ? Point{along, seam} : Point{seam, along};
        gaps += std::none_of(plane.points.begin(), plane.points.end(), [&](Point at) {
            return std::hypot(at.x - spot.x, at.y - spot.y) < kRadius + 1e-6;
        });
    }
    EXPECT_EQ(conflicts, 0U);
    EXPECT_EQ(gaps, 0U);
}

TEST(Tiles, OfClassesFit) {
    Request request = tile_of(0);
    request.radius.reset();
    request.classes.names = {"a", "b", "c"};
    request.classes.distances = distances_by_sum(std::vector{0.08, 0.04, 0.02});
    const std::vector<Result> tiles = tiles_of(request, 0.24, 30);
    Claim claim;
    claim.classes = request.classes;
    claim.tolerance = 16 * 0x1p-27;
    EXPECT_TRUE(Plane(tiles, 5, 4, 1).prove_inside(claim, 5, 4, 0.16).maximal);
    EXPECT_EQ(tests::refusal_of([&] { frame_of(request, 0.23); }),
              "frame 0.23: must be at least 0.24, 1.5 times the greatest distance of two points, "
              "and under half of the domain's shorter side, 0.5");
}

TEST(Tiles, OfAFieldAndAMaskFit) {
    Request request = tile_of(0);
    request.radius.reset();
    request.scale = 0.03;
    const Field field = tests::noise_field(6, 6, 3);
    const Mask mask = tests::chess_mask(4, 4);
    request.field = &field;
    request.mask = &mask;
    double least = 1;
    for (const double importance : field.importance)
        if (importance > 0) least = std::min(least, importance);
    request.scale = 0.3 * std::sqrt(least);  // the greatest radius is 0.3
    const std::vector<Result> tiles = tiles_of(request, 0.45, 20);
    // All together, on the field and the mask of all.
    Field wide{24, 18, {}};
    Mask wide_mask{16, 12, {}};
    for (std::uint32_t i = 0; i < 24 * 18; ++i)
        wide.importance.push_back(field.importance[i / 24 % 6 * 6 + i % 24 % 6]);
    for (std::uint32_t i = 0; i < 16 * 12; ++i)
        wide_mask.allowed.push_back(mask.allowed[i / 16 % 4 * 4 + i % 16 % 4]);
    const Plane plane(tiles, 4, 3, 6);
    Claim claim;
    claim.domain = {4, 3, Boundary::torus};  // its edges fit as all others do
    claim.field = &wide;
    claim.mask = &wide_mask;
    claim.scale = *request.scale;
    const Proof proof = prove(plane.points, claim);
    EXPECT_TRUE(proof.kept && proof.covered) << proof.forbidden.has_value();
}

TEST(AFrame, IsRefusedWhereTilesWouldNotFit) {
    const auto refusal = [](double width, const auto& change) {
        Request request = tile_of(0.1);
        change(request);
        return tests::refusal_of([&] { frame_of(request, width); });
    };
    const auto nothing = [](Request&) {};
    EXPECT_EQ(refusal(0.15, nothing), "accepted");
    const std::string range =
        ": must be at least 0.15, 1.5 times the greatest distance of two points, "
        "and under half of the domain's shorter side, 0.5";
    EXPECT_EQ(refusal(0.1, nothing), "frame 0.1" + range);
    EXPECT_EQ(refusal(0.5, nothing), "frame 0.5" + range);
    EXPECT_EQ(refusal(std::nan(""), nothing), "frame nan" + range);
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.radius = std::nan(""); }),
              "radius nan: must be a finite number greater than 0");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.radius = std::numeric_limits<double>::infinity(); }),
              "radius inf: must be a finite number greater than 0");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.radius = 0.4; }),
              "frame 0.2: 1.5 times the greatest distance of two points, 0.6, must be under half "
              "of the domain's shorter side, 0.5: give a smaller radius or a larger domain");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.domain.boundary = Boundary::box; }),
              "frame on a box: is for a torus, whose edges wrap");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.limit = 9; }),
              "frame with a limit: sets that have gaps leave them between tiles, too");
    EXPECT_EQ(refusal(0.2,
                      [](Request& r) {
                          r.radius.reset();
                          r.count = 9;
                      }),
              "frame with a count: each set would have a radius of its own");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.mode = Mode::lines; }),
              "frame with mode lines: is for mode exact");
    EXPECT_EQ(refusal(0.2, [](Request& r) { r.progressive = true; }),
              "frame with a progressive order: the frame would come first");
}

}  // namespace frame_test

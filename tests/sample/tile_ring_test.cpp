// Tiles with one frame: many fit side by side in any order. Two of any kind are judged by hostile.
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

#include "refusal.h"

namespace tile_ring_test {

using namespace lacuna;

Request tile_of(double radius) {
    Request request;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = "cpu";
    return request;
}

std::vector<Result> tiles_of(Request request, double width, std::size_t count) {
    const TileRing frame = tile_ring(request, width);
    request.keep = frame.points;
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

// Tiles in a grid of columns x rows, in random order. Proves what lies at least `ring` inside of
// the plane: the rest are its neighbours.
Proof prove_inside(const std::vector<Result>& tiles, int columns, int rows, std::uint64_t seed,
                   double radius) {
    std::mt19937_64 random(seed);
    Claim claim;
    claim.radius = radius;
    claim.domain = {columns - 2 * radius, rows - 2 * radius, Boundary::box, radius, radius};
    std::vector<Point> inside, outside;
    for (int i = 0; i < columns * rows; ++i)
        for (const Point& at : tiles[random() % tiles.size()].points) {
            const Point there{at.x + i % columns, at.y + i / columns};
            (claim.domain.holds(there) ? inside : outside).push_back(there);
        }
    claim.keep = outside;
    return prove(inside, claim);
}

TEST(Tiles, OfOneFrameFitInAnyOrderHoweverMany) {
    constexpr double kRadius = 0.06;
    const std::vector<Result> tiles = tiles_of(tile_of(kRadius), 1.5 * kRadius, 200);
    for (std::size_t i = 1; i < tiles.size(); ++i) EXPECT_NE(tiles[i].points, tiles[0].points);
    // Each of the 200 lies somewhere: a grid of 20 x 10 in random order, and four more.
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        const Proof proof = prove_inside(tiles, 20, 10, seed, kRadius);
        EXPECT_TRUE(proof.maximal) << proof.least_distance << ", " << proof.largest_gap_distance;
    }
}

// The options that refuse these by pairs are rows of tests/refusals.txt.
TEST(AFrame, IsRefusedWhereTilesWouldNotFit) {
    const auto refusal = [](const Request& request) {
        return tests::refusal_of([&] { tile_ring(request, 0.15); });
    };
    const Request tile = tile_of(0.1);
    Request box = tile, lines = tile, limited = tile, counted = tile, ordered = tile;
    box.domain.boundary = Boundary::box;
    lines.mode = Mode::lines;
    limited.limit = 9;
    counted.radius.reset();
    counted.count = 9;
    ordered.progressive = true;
    EXPECT_EQ(refusal(tile), "accepted");
    EXPECT_EQ(refusal(box), "frame on a box: is for a torus, whose edges wrap");
    EXPECT_EQ(refusal(lines), "frame with mode lines: is for mode exact");
    EXPECT_EQ(refusal(limited),
              "frame with a limit: sets that have gaps leave them between tiles, too");
    EXPECT_EQ(refusal(counted), "frame with --count: each set would have a radius of its own");
    EXPECT_EQ(refusal(ordered), "frame with a progressive order: the frame would come first");
}

}  // namespace tile_ring_test

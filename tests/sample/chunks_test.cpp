// Chunks: sets beside sets. Kept points outside of the domain keep their distance and cover spots,
// so that chunk after chunk, in any order, makes one maximal set.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "judge/judge.h"
#include "refusal.h"

namespace chunks_test {

using namespace lacuna;
using judge::Random;

// Points with their classes, which have none or all one.
struct Joined {
    std::vector<Point> points;
    std::vector<std::uint8_t> classes;

    void add(const Result& set, Point by = {0, 0}) {
        for (const Point& at : set.points) points.push_back({at.x + by.x, at.y + by.y});
        classes.insert(classes.end(), set.classes.begin(), set.classes.end());
    }
};

Request chunk_of(const Request& request, const Domain& domain, const Joined& kept) {
    Request chunk = request;
    chunk.domain = domain;
    chunk.keep = kept.points;
    chunk.keep_classes = kept.classes;
    return chunk;
}

Proof proof_of(const Request& request, const Result& set) {
    return prove(set.points, claim_of(request, set));
}

Request uniform(double radius) {
    Request request;
    request.radius = radius;
    request.run_on.backend = "cpu";
    return request;
}

Request chunk_of_classes() {
    Request request;
    request.classes.names = {"trees", "bushes", "grass"};
    request.classes.distances = distances_by_sum(std::vector{0.06, 0.03, 0.012});
    request.run_on.backend = "cpu";
    return request;
}

// 3 x 3 chunks in random order. Each keeps the points of all that were made before, and is proven;
// in the end all are one set.
void expect_one_set(const Request& request, std::uint64_t seed) {
    Random random(seed);
    std::vector<int> order(9);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    const Domain all{3, 1.5, Boundary::box, -7, 100};
    Joined joined;
    double set_size = 0;
    for (const int chunk : order) {
        const Domain domain{1, 0.5, Boundary::box, all.x0 + chunk % 3, all.y0 + chunk / 3 * 0.5};
        Request one = chunk_of(request, domain, joined);
        one.seed = random();
        const Result set = sample(one);
        ASSERT_TRUE(set.maximal);
        const Proof proof = proof_of(one, set);
        EXPECT_TRUE(proof.maximal) << "chunk " << chunk;
        joined.add(set);
        set_size = set.radius;
    }
    Claim claim;
    claim.domain = all;
    claim.radius = request.radius.value_or(0);
    claim.classes = request.classes;
    claim.class_of_points = joined.classes;
    claim.tolerance = 2 * 0x1p-27 * 4 * 3;  // of the chunks, with classes of greater distances
    EXPECT_TRUE(prove(joined.points, claim).maximal);
    Request whole = request;
    whole.domain = all;
    const judge::Judge judge(whole, joined.points, joined.classes, set_size);
    EXPECT_EQ(judge.fault(), "");
    EXPECT_LE(judge.largest_gap(random).room, *claim.tolerance);
}

TEST(ChunkAfterChunk, MakesOneMaximalSetInAnyOrder) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) expect_one_set(uniform(0.04), seed);
    expect_one_set(uniform(0.45), 6);  // nearly as wide as a chunk
}

TEST(ChunkAfterChunk, MakesOneMaximalSetOfClasses) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) expect_one_set(chunk_of_classes(), seed);
}

TEST(ChunkAfterChunk, NeedsOnlyThePointsWithinTheGreatestDistance) {
    for (const Request& request : {uniform(0.05), chunk_of_classes()}) {
        Random random(3);
        Request first = request;
        first.domain = {1, 1, Boundary::box, -1, 0};
        Joined all;
        all.add(sample(first));
        Joined near;
        const double reach = request.radius.value_or(0.12);
        for (std::size_t i = 0; i < all.points.size(); ++i) {
            if (all.points[i].x < -reach) continue;
            near.points.push_back(all.points[i]);
            if (!all.classes.empty()) near.classes.push_back(all.classes[i]);
        }
        ASSERT_LT(near.points.size(), all.points.size() / 2);
        const Domain domain{1, 1};
        EXPECT_EQ(sample(chunk_of(request, domain, near)).points,
                  sample(chunk_of(request, domain, all)).points);
        // Without any of these the set is that without kept points.
        Joined far;
        for (const Point& point : all.points)
            if (point.x < -reach) far.points.push_back(point);
        far.classes.resize(request.classes.names.empty() ? 0 : far.points.size());
        EXPECT_EQ(sample(chunk_of(request, domain, far)).points,
                  sample(chunk_of(request, domain, {})).points);
    }
}

// A chunk beside two others, with points of its own that are kept.
class AChunk : public testing::Test {
protected:
    AChunk() {
        Request first = uniform(0.05);
        first.domain = {1, 1, Boundary::box, -1, 0};
        // The second lies on the edge of both domains, and belongs to the one on its right.
        kept_.points = {{0.5, 0.5}, {0, 0.25}};
        kept_.add(sample(chunk_of(first, first.domain, kept_)));
    }
    Request request() const { return chunk_of(uniform(0.05), {1, 1}, kept_); }

    Joined kept_;
};

TEST_F(AChunk, OfALimitOrACountHasAsManyPointsOfItsOwn) {
    Request limited = request();
    limited.limit = 7;
    const Result seven = sample(limited);
    EXPECT_EQ(seven.points[0], (Point{0.5, 0.5}));
    EXPECT_EQ(seven.points[1], (Point{0, 0.25}));
    EXPECT_EQ(seven.points.size(), 7U);
    EXPECT_FALSE(seven.maximal);
    Request counted = request();
    counted.radius.reset();
    counted.count = 300;
    const Result set = sample(counted);
    EXPECT_EQ(set.points.size(), 300U);
    EXPECT_LT(set.radius, 0.05);
    EXPECT_TRUE(proof_of(counted, set).kept);
    counted.count = 1;  // two are kept
    EXPECT_EQ(tests::refusal_of([&] { sample(counted); }),
              "count 1: must be at least 2, the number of kept points, which count");
}

TEST_F(AChunk, MayBeFullFromTheBeginning) {
    Request full = uniform(1.5);
    const std::vector<Point> around{{-0.1, 0.5}};
    full.keep = around;
    const Result set = sample(full);
    EXPECT_TRUE(set.points.empty());
    EXPECT_TRUE(set.maximal);
    const Proof proof = proof_of(full, set);
    EXPECT_TRUE(proof.kept && proof.covered);
}

TEST_F(AChunk, IsRefutedWithoutANeighbourThatCoversASpot) {
    const Result set = sample(request());
    std::size_t refuted = 0;
    for (std::size_t i = 0; i < kept_.points.size(); ++i) {
        if (kept_.points[i].x >= 0) continue;
        std::vector<Point> fewer = kept_.points;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        Claim claim = claim_of(request(), set);
        claim.keep = fewer;
        const Proof proof = prove(set.points, claim);
        EXPECT_TRUE(proof.kept);
        refuted += !proof.covered;
    }
    EXPECT_GT(refuted, 3U);
}

TEST(ChunksOfClasses, RefusePointsOutsideOfMasksOfDifferentSizes) {
    const Mask wide{2, 1, {1, 0}}, same{2, 1, {0, 1}}, high{1, 2, {1, 0}};
    const std::vector<Point> keep{{-0.5, 0.5}};
    const std::vector<std::uint8_t> first{0};
    Request request;
    request.keep = keep;
    request.keep_classes = first;
    request.classes = {.names = {"a", "b"}, .distances = {0.1, 0.1, 0.1, 0.1}};
    request.places.masks = {&wide, &same};
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }), "accepted");
    request.places.masks[1] = &high;
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "keep point 0 at (-0.5, 0.5): with masks of different sizes must lie in the domain, "
              "[0, 1] x [0, 1]");
}

// The domain, or a pixel of its mask, would have no unit of the grid that it shares with the points
// outside.
TEST(ChunksOfClasses, RefuseDistancesFarBeyondTheDomain) {
    const auto refusal = [](double far, const Mask* mask) {
        Request request;
        request.classes.names = {"trees", "grass"};
        request.classes.distances = {2 * far, far, far, far / 1000};
        request.places.border = 0.3;
        request.places.mask = mask;
        const std::vector<Point> keep{{-far, 0.5}};
        const std::vector<std::uint8_t> keep_classes{0};
        request.keep = keep;
        request.keep_classes = keep_classes;
        return tests::refusal_of([&] { sample(request); });
    };
    const std::string begin = " outside: is within the greatest distance, but with it the domain ";
    const std::string end =
        " long: 2^20 times its shorter side, and 2^30 pixels of a mask or of "
        "polygons";
    EXPECT_EQ(refusal(1e6, nullptr), "accepted");
    EXPECT_EQ(refusal(1e9, nullptr), "keep a point 1e+09" + begin + "may be at most 1048576" + end);
    EXPECT_EQ(refusal(1e10, nullptr),
              "keep a point 1e+10" + begin + "may be at most 1048576" + end);
    const Mask fine{65536, 1, std::vector<std::uint8_t>(65536, 1)};
    EXPECT_EQ(refusal(1e4, &fine), "accepted");
    EXPECT_EQ(refusal(1e5, &fine), "keep a point 1e+05" + begin + "may be at most 16384" + end);
}

// 6 x 6 chunks of a plane, some left of 0 and below, in three orders: each is the same, and those
// in the middle are one set beside the others.
void expect_same_in_any_order(const Request& request, double size, double tolerance) {
    std::vector<std::pair<std::int64_t, std::int64_t>> order;
    for (std::int64_t j = -3; j < 3; ++j)
        for (std::int64_t i = -3; i < 3; ++i) order.emplace_back(i, j);
    std::vector<MadeChunks> results;
    Observer nobody;
    for (const int which : {0, 1, 2}) {
        if (which == 1) std::reverse(order.begin(), order.end());
        Random random(5);
        if (which == 2) std::shuffle(order.begin(), order.end(), random);
        MadeChunks made, all;
        for (const auto& [i, j] : order) {
            if (which == 2) made.clear();
            const Chunk one = chunk(request, i, j, size, made, nobody);
            const Result set = sample(one.request);
            if (which == 0) {
                EXPECT_TRUE(proof_of(one.request, set).maximal) << i << "," << j;
            }
            all[{i, j}] = {set.points, set.classes};
        }
        results.push_back(std::move(all));
    }
    Joined inner, ring;
    for (const auto& [at, chunk] : results[0]) {
        for (const std::size_t other : {1U, 2U}) {
            EXPECT_EQ(chunk.points, results[other][at].points) << at.first << "," << at.second;
            EXPECT_EQ(chunk.classes, results[other][at].classes);
        }
        for (const Point& point : chunk.points)
            EXPECT_TRUE(std::floor(point.x / size) == static_cast<double>(at.first) &&
                        std::floor(point.y / size) == static_cast<double>(at.second));
        const bool is_inner = std::max(std::abs(2 * at.first + 1), std::abs(2 * at.second + 1)) < 4;
        (is_inner ? inner : ring).add({.points = chunk.points, .classes = chunk.classes});
    }
    // Those on the rim keep points of others, which are not among these.
    Request whole =
        chunk_of(request, {4 * size, 4 * size, Boundary::box, -2 * size, -2 * size}, ring);
    for (Outline& outline : whole.places.outlines) outline.polygons.page.reset();
    const Result all{.points = inner.points,
                     .classes = inner.classes,
                     .radius = request.radius.value_or(0),
                     .edge = request.places.edge.value_or(0),
                     .maximal = true};
    Claim claim = claim_of(whole, all);
    claim.tolerance = tolerance;
    EXPECT_TRUE(prove(inner.points, claim).maximal);
    if (!request.places.outlines.empty() || request.places.mask != nullptr) return;
    const judge::Judge judge(whole, inner.points, inner.classes, request.radius.value_or(0.024));
    EXPECT_EQ(judge.fault(), "");
    Random random(6);
    EXPECT_LE(judge.largest_gap(random).room, tolerance);
}

TEST(ChunksOfAPlane, AreTheSameInAnyOrderAndOneMaximalSet) {
    const double of_one = 2 * 0x1p-27 * 4;
    expect_same_in_any_order(uniform(0.06), 0.3, of_one);  // 0.3 has no exact multiples
    expect_same_in_any_order(uniform(0.4), 0.5, of_one);
    expect_same_in_any_order(chunk_of_classes(), 0.2, of_one * 5);
    Request by_priority = chunk_of_classes();
    by_priority.classes.by_priority = true;
    const Chunk one = chunk(by_priority, 1, 1, 0.5);
    EXPECT_TRUE(proof_of(one.request, sample(one.request)).maximal);
}

TEST(ChunksOfAPlane, HaveOneMaskAndThePolygonsOfThePlane) {
    Request request = uniform(0.05);
    Mask map{8, 8, std::vector<std::uint8_t>(64, 1)};
    for (const std::size_t lake : {27U, 28U, 35U, 9U}) map.allowed[lake] = 0;
    map.extent = Domain{2, 2, Boundary::box, -1, -1};
    request.places.mask = &map;
    Request part = request;
    part.domain = {0.5, 0.5, Boundary::box, -0.25, 0};
    for (const Point& at : sample(part).points)
        EXPECT_FALSE(at.x < 0 && at.y < 0.25) << "in the lake of pixel 27, " << at.x << " " << at.y;
    part.domain.x0 = 0.1;
    EXPECT_EQ(tests::refusal_of([&] { sample(part); }),
              "mask of 8 pixels from -1 to 1: the domain, from 0.1 to 0.6, must begin and end at "
              "borders of pixels");
    request.domain = {2, 2, Boundary::box, -1, -1};
    expect_same_in_any_order(request, 0.25, 2 * 0x1p-27 * 4);
    Request ponds = uniform(0.05);
    Outline pond;
    pond.role = Role::outside;
    pond.polygons.rings = {{{-0.6, -0.5}, {0.7, 0.1}, {0.2, 0.6}}};
    pond.polygons.page = Domain{5, 5};
    ponds.places.outlines = {pond};
    ponds.places.edge = 0.003;
    expect_same_in_any_order(ponds, 0.25, 2 * 0x1p-27 * 4);
}

TEST(ChunksOfAPlane, RefuseWhatLeavesGapsWhereTheyMeet) {
    const auto refusal = [](double size, const auto& change) {
        Request request = uniform(0.1);
        change(request);
        return tests::refusal_of([&] { chunk(request, 1, 0, size); });
    };
    EXPECT_EQ(refusal(0.1, [](Request&) {}),
              "chunk-size 0.1: must be a finite number over 0.1, the greatest distance of two "
              "points");
    const Mask mask{1, 1, {1}};
    const auto with = [](const std::string& text) { return text.substr(0, text.find(':')); };
    EXPECT_EQ(with(refusal(1, [&](Request& r) { r.places.mask = &mask; })), "chunk with a mask");
    EXPECT_EQ(with(refusal(1, [](Request& r) { r.places.border = 0.1; })), "chunk with a border");
    EXPECT_EQ(with(refusal(1, [](Request& r) { r.limit = 3; })), "chunk with a limit");
    EXPECT_EQ(with(refusal(1, [](Request& r) { r.domain.boundary = Boundary::torus; })),
              "chunk on a torus");
    EXPECT_EQ(tests::refusal_of([&] { chunk(uniform(0.1), 1 << 21, 0, 1); }),
              "chunk 2097152,0: must be two whole numbers of at most 1048576");
}

}  // namespace chunks_test

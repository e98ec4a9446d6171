// Progressive orders: every prefix is as even as a set of its own size, and every level is maximal.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/available.h"
#include "refusal.h"
#include "sample/distance.h"

namespace lacuna {
namespace progressive_test {

Request progressive(std::uint64_t count, std::uint64_t seed = 0) {
    Request request;
    request.progressive = true;
    request.domain.boundary = Boundary::torus;
    request.count = count;
    request.seed = seed;
    return request;
}

// The least distance of each prefix, over that of a hexagonal lattice with as many points.
std::vector<double> relative_distances(std::span<const Point> points, const Request& request) {
    std::vector<double> relative;
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            least = std::min(least, tests::distance_on(request.domain, points[i], points[k]));
        const double area =
            request.domain.width * request.domain.height / static_cast<double>(i + 1);
        relative.push_back(least / std::sqrt(2 / std::sqrt(3.0) * area));
    }
    return relative;
}

TEST(Progressive, IsEvenAtEveryPrefix) {
    double sum = 0;
    std::size_t prefixes = 0;
    for (const std::uint64_t seed : {0U, 1U, 2U, 3U}) {
        const Request request = progressive(2048, seed);
        const std::vector<double> relative = relative_distances(sample(request).points, request);
        for (std::size_t i = 15; i < relative.size(); ++i) {
            ASSERT_GE(relative[i], 0.70) << i + 1 << " points of seed " << seed;
            sum += relative[i];
            ++prefixes;
        }
    }
    EXPECT_GE(sum / static_cast<double>(prefixes), 0.74);
}

TEST(Progressive, IsTheSameSequenceForEveryCount) {
    const std::vector<Point> all = sample(progressive(700)).points;
    for (const std::uint64_t count : {1U, 16U, 17U, 300U, 699U}) {
        const std::vector<Point> some = sample(progressive(count)).points;
        ASSERT_EQ(some.size(), count);
        EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << count;
    }
    Request limited = progressive(700);
    limited.limit = 123;
    EXPECT_EQ(sample(limited).points, std::vector<Point>(all.begin(), all.begin() + 123));
}

// Requests of all kinds, with what they refer to.
struct Kinds {
    Field field{3, 2, {0.2, 1, 0.5, 0.9, 0, 0.4}};
    Mask mask{4, 4, {1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1}};
    std::vector<Point> keep{{0.5, 0.5}, {0.53, 0.5}, {0.9, 0.2}};

    std::vector<Request> all() const {
        Request plain;
        plain.progressive = true;
        plain.radius = 0.04;
        plain.seed = 5;
        Request torus = plain;
        torus.domain.boundary = Boundary::torus;
        Request wide = plain;
        wide.domain.width = 7;
        Request within = plain;
        within.border = 0.1;
        within.mask = &mask;
        Request kept = plain;
        kept.radius = 0.025;
        kept.keep = keep;
        Request follows = plain;
        follows.radius.reset();
        follows.scale = 0.03;
        follows.field = &field;
        Request all_of_it = follows;
        all_of_it.mask = &mask;
        all_of_it.keep = keep;
        all_of_it.scale = 0.02;
        return {plain, torus, wide, within, kept, follows, all_of_it};
    }
};

TEST(Progressive, IsMaximalAtTheEndOfEveryLevel) {
    const Kinds kinds;
    for (const Request& request : kinds.all()) {
        const Result result = sample(request);
        EXPECT_TRUE(result.maximal);
        ASSERT_GE(result.levels.size(), 9U);
        EXPECT_EQ(result.levels.back().points, result.points.size());
        EXPECT_EQ(result.levels.back().size, request.field ? *request.scale : *request.radius);
        for (const Level& level : result.levels) {
            Claim claim;
            claim.domain = request.domain;
            claim.border = request.border;
            claim.mask = request.mask;
            claim.field = request.field;
            claim.keep = request.keep;
            (request.field ? claim.scale : claim.radius) = level.size;
            const std::span<const Point> first = std::span(result.points).first(level.points);
            const Proof proof = prove(first, claim);
            ASSERT_TRUE(proof.maximal) << level.points << " points at " << level.size;
            // One point less is not maximal.
            if (level.points > request.keep.size() + 1) {
                const Proof less = prove(first.first(first.size() - 1), claim);
                ASSERT_FALSE(less.maximal) << level.points;
            }
        }
    }
}

TEST(Progressive, HasKeptPointsFirst) {
    const Kinds kinds;
    Request request = kinds.all()[4];
    const Result result = sample(request);
    EXPECT_TRUE(std::equal(kinds.keep.begin(), kinds.keep.end(), result.points.begin()));
    // Levels begin where the kept points, 0.03 apart, are not too close together.
    EXPECT_LE(result.levels.front().size, 0.03);
    request.radius = 0.05;
    const std::string refusal = tests::refusal_of([&] { sample(request); });
    EXPECT_TRUE(refusal.starts_with("keep point 0")) << refusal;
    EXPECT_NE(refusal.find("at least 0.05"), std::string::npos) << refusal;
    // On the same place points are too close at any radius.
    const std::vector<Point> twice{{0.5, 0.5}, {0.5, 0.5}};
    Request counted = progressive(50);
    counted.keep = twice;
    EXPECT_TRUE(tests::refusal_of([&] { sample(counted); }).starts_with("keep point 0"));
}

class ProgressiveOn : public tests::OnBackend {};

TEST_P(ProgressiveOn, IsTheReferencesSequence) {
    const Kinds kinds;
    for (Request request : kinds.all()) {
        request.limit = 150;
        request.place.backend = "reference";
        const Result expected = sample(request);
        request.place.backend = GetParam();
        const Result got = sample(request);
        ASSERT_EQ(got.points, expected.points);
        EXPECT_EQ(got.draws, expected.draws);
        EXPECT_EQ(got.rounds, expected.rounds);
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, ProgressiveOn, tests::kParallelBackends,
                         tests::name_of_parameter);

TEST(Progressive, IsCutWithinKeptPoints) {
    const Kinds kinds;
    Request request = progressive(2);
    request.keep = kinds.keep;
    EXPECT_EQ(sample(request).points, (std::vector<Point>{kinds.keep[0], kinds.keep[1]}));
}

TEST(Progressive, IsRefusedAtOnceWhereItWouldTakeTooMuch) {
    Request request = progressive(1'000'000'000'000);
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("count 1000000000000: "));
    request = progressive(2'000'000);
    request.place.memory_limit_bytes = 100'000'000;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("count 2000000: needs"));
    request.count.reset();
    request.radius = 1e-9;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("radius 1e-09: makes"));
    request.radius = -1;
    EXPECT_TRUE(tests::refusal_of([&] { sample(request); }).starts_with("radius -1: must be"));
}

TEST(Progressive, IsForModeExact) {
    Request request = progressive(100);
    request.mode = Mode::lines;
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "progressive with mode lines: is for mode exact");
}

}  // namespace progressive_test
}  // namespace lacuna

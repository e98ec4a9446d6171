// Points that are there already, in a progressive order.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "judge/judge.h"
#include "refusal.h"

namespace lacuna {
namespace {

constexpr OrderOptions kTorus{.domain = {1, 1, Boundary::torus}};

std::vector<Point> maximal_set(std::uint64_t count) {
    Request request;
    request.count = count;
    request.domain.boundary = Boundary::torus;
    return sample(request).points;
}

std::vector<Point> in_order(std::span<const Point> points,
                            const std::vector<std::uint32_t>& order) {
    std::vector<Point> ordered;
    for (const std::uint32_t index : order) ordered.push_back(points[index]);
    return ordered;
}

bool is_permutation(std::vector<std::uint32_t> order, std::size_t count) {
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    return order == all;
}

double mean_from_16(std::span<const double> values) {
    return std::accumulate(values.begin() + 14, values.end(), 0.0) /
           static_cast<double>(values.size() - 14);
}

TEST(AnOrder, IsEvenAtEveryPrefix) {
    const std::vector<Point> points = maximal_set(2000);
    const auto order = progressive_order(points, nullptr, kTorus);
    ASSERT_TRUE(is_permutation(order, points.size()));
    OrderOptions other = kTorus;
    other.seed = 1;
    EXPECT_NE(progressive_order(points, nullptr, other), order);
    const std::vector<double> relative =
        judge::relative_distances(kTorus.domain, in_order(points, order));
    EXPECT_GE(*std::min_element(relative.begin() + 14, relative.end()), 0.55);
    EXPECT_GE(mean_from_16(relative), 0.64);
    // As admitted, the last points are as near as the first.
    EXPECT_LE(mean_from_16(judge::relative_distances(kTorus.domain, points)), 0.55);
}

// All pairs are asked. A level takes each point that is at least the level's size away from all
// points taken before. So a point may be taken at a longer distance than an earlier one, but not by
// more than the step from a level to the next.
TEST(AnOrder, TakesPointsAtDistancesThatShrink) {
    Field field{4, 4, {}};
    for (int i = 0; i < 16; ++i) field.importance.push_back(0.2 + i % 5);
    for (const Boundary boundary : {Boundary::box, Boundary::torus})
        for (const Field* given : {static_cast<const Field*>(nullptr), &std::as_const(field)}) {
            const std::vector<Point> points = maximal_set(600);
            const Domain domain{1, 1, boundary};
            const auto ordered =
                in_order(points, progressive_order(points, given, {.domain = domain}));
            Request request{.domain = domain};
            request.field = given;
            const judge::Judge judge(request, ordered, {}, 1);
            double least = INFINITY;
            for (std::size_t i = 1; i < ordered.size(); ++i) {
                double own = INFINITY;
                for (std::size_t k = 0; k < i; ++k) own = std::min(own, judge.share_of(i, k));
                // The first level, of about 16 points, takes points at any distance over its own.
                if (i > 40) {
                    EXPECT_LE(own, least * std::exp2(1.0 / 32) * (1 + 1e-9)) << i;
                }
                least = std::min(least, own);
            }
        }
}

TEST(AnOrder, TakesPointsOnTheSamePlaceAtTheEnd) {
    const std::vector<Point> points{{0.5, 0.5}, {0.5, 0.5}, {0.1, 0.1}, {0.5, 0.5}};
    const auto order = progressive_order(points, nullptr, {});
    ASSERT_TRUE(is_permutation(order, 4));
    EXPECT_TRUE(order[0] == 2 || order[1] == 2);
    EXPECT_TRUE(progressive_order({}, nullptr, {}).empty());
    EXPECT_EQ(progressive_order(std::vector<Point>{{0.3, 0.3}}, nullptr, {}).size(), 1U);
}

TEST(AnOrder, OfPointsElsewhereIsRefused) {
    const auto refusal = [](Point point, const Field* field) {
        return tests::refusal_of(
            [&] { progressive_order(std::vector<Point>{point}, field, OrderOptions{}); });
    };
    EXPECT_TRUE(refusal({0.5, 1.5}, nullptr).starts_with("points point 0 at (0.5, 1.5): must lie"));
    const Field half{2, 1, {1, 0}};
    EXPECT_TRUE(refusal({0.9, 0.5}, &half).ends_with("must lie where the field is not 0"));
    EXPECT_EQ(refusal({0.1, 0.5}, &half), "accepted");
}

}  // namespace
}  // namespace lacuna

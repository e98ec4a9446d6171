// A pen path visits every dot once, and its length is near the shortest possible.
#include "drawing/pen/pen_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace lacuna::pen {
namespace {

using Points = std::vector<Point>;
using Order = std::vector<std::uint32_t>;

bool yes() {
    return true;
}

Points random_points(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
    Points points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({coordinate(), coordinate()});
    return points;
}

Points along(const Points& points, const Order& order) {
    Points path;
    for (const std::uint32_t index : order) path.push_back(points[index]);
    return path;
}

double length_along(const Points& points, const Order& order) {
    return path_length(along(points, order));
}

double between(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

bool visits_each_once(Order order, std::size_t count) {
    Order all(count);
    std::iota(all.begin(), all.end(), 0U);
    std::sort(order.begin(), order.end());
    return order == all;
}

double shortest_length(const Points& points) {
    Order order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    double shortest = length_along(points, order);
    while (std::next_permutation(order.begin(), order.end()))
        shortest = std::min(shortest, length_along(points, order));
    return shortest;
}

RC_GTEST_PROP(PenPath, GivenAnyPointsThenEachIsVisitedOnce, ()) {
    // Few different coordinates, so that some points coincide and many distances are equal.
    const auto places = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 12), rc::gen::inRange(0, 12)));
    Points points;
    for (const auto& [x, y] : places) points.push_back({x / 12.0, y / 12.0});
    RC_ASSERT(visits_each_once(pen_path(points, yes), points.size()));
}

TEST(PenPath, GivenAHundredPointsOnOneSpotAndAFewElsewhereThenEachIsVisitedOnce) {
    Points points(100, Point{0.5, 0.25});
    points.insert(points.end(), {{0, 0}, {1, 0}, {1, 1}});
    const Order order = pen_path(points, yes);
    EXPECT_TRUE(visits_each_once(order, points.size()));
    EXPECT_LT(length_along(points, order), 2.7);
}

TEST(PenPath, GivenPointsOnALineThenItRunsAlongTheLine) {
    Points points;
    for (const double x : {5, 1, 8, 0, 3, 9, 2, 7, 6, 4, 11, 10}) points.push_back({x, 2 * x});
    EXPECT_DOUBLE_EQ(length_along(points, pen_path(points, yes)), 11 * std::sqrt(5.0));
}

TEST(PenPath, GivenEightPointsThenItIsHardlyLongerThanTheShortest) {
    double found = 0, shortest = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Points points = random_points(8, seed);
        found += length_along(points, pen_path(points, yes));
        shortest += shortest_length(points);
    }
    EXPECT_GE(found, shortest * 0.999999);
    EXPECT_LT(found, shortest * 1.03);
}

// The shortest tour through N random points of the unit square is 0.7124 sqrt(N) long for large N
// (Johnson, McGeoch and Rothberg, "Asymptotic experimental analysis for the Held-Karp traveling
// salesman bound", 1996); a Hilbert curve is 0.98 sqrt(N).
TEST(PenPath, GivenRandomPointsThenItIsAboutFivePercentLongerThanTheShortest) {
    const Points points = random_points(30000, 7);
    const double unit = std::sqrt(static_cast<double>(points.size()));
    const double length = length_along(points, pen_path(points, yes));
    EXPECT_LT(length, 0.7124 * 1.055 * unit);
    EXPECT_GT(length, 0.7124 * 0.99 * unit);
    EXPECT_LT(length, 0.78 * length_along(points, hilbert_order(points)));
}

// The distance from a dot to its eighth neighbour.
double eighth_distance(const Points& points, const Point& from) {
    std::vector<double> distances;
    for (const Point& other : points) distances.push_back(between(from, other));
    std::nth_element(distances.begin(), distances.begin() + 8, distances.end());
    return distances[8];  // itself is the first
}

// Distances in whole numbers differ from distances in doubles by less than this.
constexpr double kRounding = 1e-6;

TEST(PenPath, WhenTwoOfItsEdgesAreExchangedBesideNearDotsThenItIsNoShorter) {
    const Points points = random_points(800, 3);
    const Points path = along(points, pen_path(points, yes));
    std::size_t tried = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double near = eighth_distance(path, path[i]);
        for (std::size_t j = 0; j + 1 < path.size(); ++j) {
            if (i == j || between(path[i], path[j]) > near) continue;
            const double now = between(path[i], path[i + 1]) + between(path[j], path[j + 1]);
            const double then = between(path[i], path[j]) + between(path[i + 1], path[j + 1]);
            ASSERT_GE(then, now - kRounding) << "at " << i << " and " << j;
            ++tried;
        }
    }
    EXPECT_GT(tried, 6000U);
}

TEST(PenPath, WhenOneDotIsMovedToBetweenNearOnesThenItIsNoShorter) {
    const Points points = random_points(800, 4);
    const Points path = along(points, pen_path(points, yes));
    std::size_t tried = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const double freed = between(path[i - 1], path[i]) + between(path[i], path[i + 1]) -
                             between(path[i - 1], path[i + 1]);
        const double near = eighth_distance(path, path[i]);
        for (std::size_t j = 0; j + 1 < path.size(); ++j) {
            if (j == i || j + 1 == i) continue;
            const double nearer =
                std::min(between(path[j], path[i]), between(path[i], path[j + 1]));
            if (nearer > near || nearer >= freed) continue;
            const double taken = between(path[j], path[i]) + between(path[i], path[j + 1]) -
                                 between(path[j], path[j + 1]);
            ASSERT_GE(taken, freed - kRounding) << i << " to after " << j;
            ++tried;
        }
    }
    EXPECT_GT(tried, 150U);
}

TEST(PenPath, GivenTheSamePointsInAnotherOrderThenThePathIsTheSame) {
    const Points points = random_points(5000, 5);
    Points shuffled = points;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(1));
    const Points one = along(points, pen_path(points, yes));
    Points other = along(shuffled, pen_path(shuffled, yes));
    if (other.front() != one.front()) std::reverse(other.begin(), other.end());
    EXPECT_EQ(one, other);
}

TEST(PenPath, GivenAClumpAMillionTimesAsDenseThenItIsNoLongerForIt) {
    Points points = random_points(20000, 6);
    for (Point& point : points) point = {0.5 + point.x * 1e-3, 0.5 + point.y * 1e-3};
    const Points spread = random_points(200, 8);
    points.insert(points.end(), spread.begin(), spread.end());
    const double length = length_along(points, pen_path(points, yes));
    EXPECT_LT(length, 1.1 * 0.7124 * (std::sqrt(200.0) + 1e-3 * std::sqrt(20000.0)));
}

TEST(PenPath, WhenToldToStopThenItThrowsCancelled) {
    const Points points = random_points(5000, 9);
    int asked = 0;
    EXPECT_THROW(pen_path(points, [&] { return ++asked < 3; }), Cancelled);
    EXPECT_EQ(asked, 3);
}

TEST(HilbertOrder, GivenTheMiddlesOfSquaresThenEachStepIsToTheNextSquare) {
    constexpr int kSquares = 32;
    Points points{{0, 0}, {1, 1}};  // they set the extent of the squares
    for (int x = 0; x < kSquares; ++x)
        for (int y = 0; y < kSquares; ++y)
            points.push_back({(x + 0.5) / kSquares, (y + 0.5) / kSquares});
    Order order = hilbert_order(points);
    ASSERT_TRUE(visits_each_once(order, points.size()));
    std::erase_if(order, [](std::uint32_t index) { return index < 2; });
    const Points curve = along(points, order);
    for (std::size_t i = 1; i < curve.size(); ++i)
        ASSERT_DOUBLE_EQ(between(curve[i - 1], curve[i]), 1.0 / kSquares) << i;
}

}  // namespace
}  // namespace lacuna::pen

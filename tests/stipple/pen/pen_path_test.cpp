// A pen path visits every dot once, and its length is near the shortest possible.
#include "stipple/pen/pen_path.h"

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

// Whether two segments of the path have a point in common that is an end of neither. Areas are
// exact for coordinates of a few bits, and for sets whose coordinates are multiples of 2^-25.
bool cross(const Points& path, std::size_t i, std::size_t j) {
    const auto side = [](const Point& a, const Point& b, const Point& c) {
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return int{area > 0} - int{area < 0};
    };
    const Point &a = path[i], &b = path[i + 1], &c = path[j], &d = path[j + 1];
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

std::size_t crossings_of(const Points& path) {
    std::size_t crossings = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) crossings += std::size_t{cross(path, i, j)};
    return crossings;
}

// The segments over ten times as long as the mean, and those that an exchange with another one
// would shorten by more than rounding can hide.
std::pair<std::size_t, std::size_t> long_segments_of(const Points& path) {
    constexpr double kRounding = 1e-6;
    const double most = 10 * path_length(path) / double(path.size() - 1);
    std::size_t all = 0, needless = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double now = between(path[i], path[i + 1]);
        if (now <= most) continue;
        ++all;
        bool helps = now > between(path.front(), path[i + 1]) + kRounding ||
                     now > between(path[i], path.back()) + kRounding;
        for (std::size_t j = 0; j + 1 < path.size() && !helps; ++j)
            helps = j != i &&
                    between(path[i], path[j]) + between(path[i + 1], path[j + 1]) + kRounding <
                        now + between(path[j], path[j + 1]);
        needless += std::size_t{helps};
    }
    return {all, needless};
}

double shortest_length(const Points& points) {
    Order order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    double shortest = length_along(points, order);
    while (std::next_permutation(order.begin(), order.end()))
        shortest = std::min(shortest, length_along(points, order));
    return shortest;
}

RC_GTEST_PROP(PenPath, GivenAnyPointsThenEachIsVisitedOnceAndNoSegmentsCross, ()) {
    // Few different coordinates, so that some points coincide and many distances are equal.
    const auto places = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 12), rc::gen::inRange(0, 12)));
    Points points;
    for (const auto& [x, y] : places) points.push_back({x / 16.0, y / 16.0});
    const Order order = pen_path(points, yes);
    RC_ASSERT(visits_each_once(order, points.size()));
    RC_ASSERT(crossings_of(along(points, order)) == 0U);
}

// Random points as dense as in a picture: their number in x grows with the fourth power of x.
Points dense_to_the_right(std::size_t count, std::uint64_t seed) {
    Points points = random_points(count, seed);
    for (Point& point : points) point.x = std::pow(point.x, 0.2);
    return points;
}

// Two hundred clumps of random points.
Points clumps(std::uint64_t seed) {
    Points points;
    for (const Point& clump : random_points(200, seed))
        for (const Point& point : random_points(20, seed + points.size()))
            points.push_back({clump.x + point.x / 200, clump.y + point.y / 200});
    return points;
}

TEST(PenPath, OfManyPointsHasNoCrossingsAndNoLongSegmentThatAnExchangeWouldShorten) {
    std::size_t all = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed)
        for (const Points& points :
             {random_points(4000, seed), dense_to_the_right(4000, seed), clumps(seed)}) {
            const Points path = along(points, pen_path(points, yes));
            EXPECT_EQ(crossings_of(path), 0U) << seed;
            const auto [segments, needless] = long_segments_of(path);
            EXPECT_EQ(needless, 0U) << "of " << segments << ", " << seed;
            all += segments;
        }
    EXPECT_GT(all, 100U) << "between clumps";
}

// A star of clumps whose points lie a few units apart: the path goes to a clump and back, and whole
// numbers hide what is saved if the way there no longer crosses the way back.
TEST(PenPath, OfPointsThatNearlyCoincideHasNoCrossings) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        std::mt19937_64 random(seed);
        Points points{{0, 0}, {1, 1}};
        for (const Point& clump : Points{{0, 0}, {0.75, 0}, {0, 0.75}, {0.75, 0.75}, {0.5, 0.5}})
            for (int i = 0; i < 3; ++i)
                points.push_back({clump.x + std::ldexp(double(random() % 4), -25),
                                  clump.y + std::ldexp(double(random() % 4), -25)});
        const Order order = pen_path(points, yes);
        ASSERT_TRUE(visits_each_once(order, points.size()));
        ASSERT_EQ(crossings_of(along(points, order)), 0U) << seed;
    }
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

// Given a set with a planted fault, the proof fails and names the fault.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "judge/plane.h"
#include "verify/sets.h"

namespace lacuna::verify {
namespace {

constexpr int kSide = 100;
constexpr double kSpacing = 1.0 / kSide;
constexpr double kRadius = 0.0075;  // between the gaps of the lattice, 0.00707, and its spacing

TEST(ASetWithoutAFault, IsMaximal) {
    EXPECT_TRUE(check(square_lattice(kSide), 1, 1, true, kRadius, 0).maximal);
    EXPECT_TRUE(check(square_lattice(kSide), 1, 1, false, kRadius, 0).maximal);
}

TEST(APointTooNear, ByOneUlpIsNamedWithTheOther) {
    std::vector<Point> points = square_lattice(kSide);
    const Point victim = points[4321];
    points.push_back({victim.x + 0.0041, victim.y});
    const double distance = points.back().x - victim.x;
    const Proof proof = check(points, 1, 1, true, std::nextafter(distance, 1), 1);
    EXPECT_FALSE(proof.kept);
    EXPECT_EQ(proof.first, 4321U);
    EXPECT_EQ(proof.second, points.size() - 1);
    EXPECT_EQ(proof.least_distance, distance);
    EXPECT_TRUE(check(points, 1, 1, true, distance, 1).kept);
}

TEST(AMissingPoint, LeavesAHoleOfTheLatticesSpacingThatIsNamed) {
    for (const std::size_t gone : {std::size_t{0}, std::size_t{4321}, std::size_t{9999}}) {
        std::vector<Point> points = square_lattice(kSide);
        const Point hole = points[gone];
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(gone));
        const Proof proof = check(points, 1, 1, true, kRadius, 0);
        EXPECT_TRUE(proof.kept);
        EXPECT_FALSE(proof.covered);
        EXPECT_NEAR(proof.largest_gap_distance, kSpacing, 4e-12);
        EXPECT_NEAR(proof.largest_gap.x, hole.x, 1e-11);
        EXPECT_NEAR(proof.largest_gap.y, hole.y, 1e-11);
    }
}

TEST(AHoleInACorner, OfTheBoxIsNamed) {
    std::vector<Point> points = square_lattice(kSide);
    points.pop_back();  // the point nearest to the corner (1, 1)
    const Proof proof = check(points, 1, 1, false, kRadius, 0);
    EXPECT_FALSE(proof.covered);
    EXPECT_NEAR(proof.largest_gap.x, 1, 1e-11);
    EXPECT_NEAR(proof.largest_gap.y, 1, 1e-11);
    EXPECT_NEAR(proof.largest_gap_distance, kSpacing * std::sqrt(2.5), 4e-12);
}

TEST(AGap, WiderByATrifleIsFoundAmongTenThousandOthers) {
    std::vector<Point> points = square_lattice(kSide);
    const double shift = 1e-9;
    // Two neighbours are shifted together, so the gap at their left grows by shift / (2 sqrt 2).
    // One shifted point would widen gaps only by the square of the shift.
    points[4321].x += shift;
    points[4322].x += shift;
    const double gap = kSpacing * std::numbers::sqrt2 / 2;
    EXPECT_FALSE(check(points, 1, 1, true, gap + 0.3 * shift, 0).covered);
    EXPECT_TRUE(check(points, 1, 1, true, gap + 0.4 * shift, 0).covered);
}

TEST(APointOutside, IsNamedAndNothingElseIsSaid) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const Point outside : {Point{1, 0.5}, Point{0.5, 1}, Point{-1e-300, 0.5}, Point{0.5, -1},
                                Point{kNaN, 0.5}, Point{0.5, kNaN}}) {
        const std::vector<Point> points{{0.5, 0.5}, outside, {7, 7}};
        const Proof proof = check(points, 1, 1, true, 0.1, 0);
        ASSERT_TRUE(proof.outside.has_value());
        EXPECT_EQ(*proof.outside, 1U);
        EXPECT_FALSE(proof.maximal);
    }
}

TEST(AQuestion, ThatMakesNoSenseIsABadRequestThatNamesTheOption) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto option_refused = [](double width, double height, double radius, double tolerance) {
        try {
            check({}, width, height, false, radius, tolerance);
        } catch (const BadRequest& error) {
            return error.option();
        }
        return std::string();
    };
    for (const double bad : {0.0, -1.0, kInfinity, std::nan(""), 1e-12})
        EXPECT_EQ(option_refused(1, 1, bad, 0), "radius") << bad;
    for (const double bad : {-1e-9, kInfinity, std::nan("")})
        EXPECT_EQ(option_refused(1, 1, 0.1, bad), "tolerance") << bad;
    for (const double bad : {0.0, -1.0, kInfinity, std::nan(""), 1e-3 / 2, 1e200})
        EXPECT_EQ(option_refused(1, bad, 0.1, 0), "domain") << bad;
    EXPECT_EQ(option_refused(1, 1, 0.1, 0), "");
}

// Samples that are snapped to lines keep their distances. But gaps that are narrower than a strip
// nearly always remain.
TEST(ASnappedSet, KeepsItsDistancesAndWhereItHasAHoleTheHoleIsReal) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        Request request;
        request.mode = Mode::lines;
        request.radius = 0.02;
        request.paper2011.snap = true;
        request.domain.boundary = boundary;
        request.run_on.backend = "cpu";
        const bool torus = boundary == Boundary::torus;
        const std::vector<Point> points = sample(request).points;
        const Proof proof = check(points, 1, 1, torus, *request.radius);
        EXPECT_TRUE(proof.kept);
        EXPECT_FALSE(proof.covered);
        EXPECT_GT(judge::distance_to_nearest(request.domain, points, proof.largest_gap), 0.02);
        EXPECT_LT(proof.largest_gap_distance, 0.02 * (1 + 1.0 / 30));
    }
}

}  // namespace
}  // namespace lacuna::verify

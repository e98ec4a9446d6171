// Given a set with a planted fault, the proof fails and names the fault.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "verify/sets.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

constexpr int kSide = 100;
constexpr double kSpacing = 1.0 / kSide;
constexpr double kRadius = 0.0075;  // over the gaps of the lattice, 0.00707, under its spacing

TEST(ASetWithoutAFault, IsMaximal) {
    EXPECT_TRUE(check(square_lattice(kSide), 1, 1, true, kRadius, 0).is_maximal());
    EXPECT_TRUE(check(square_lattice(kSide), 1, 1, false, kRadius, 0).is_maximal());
}

TEST(APointTooNear, ByOneUlpIsNamedWithTheOther) {
    std::vector<Point> points = square_lattice(kSide);
    const Point victim = points[4321];
    points.push_back({victim.x + 0.0041, victim.y});
    const double distance = points.back().x - victim.x;
    const Verdict verdict = check(points, 1, 1, true, std::nextafter(distance, 1), 1);
    EXPECT_FALSE(verdict.kept);
    EXPECT_EQ(verdict.closest.first, 4321U);
    EXPECT_EQ(verdict.closest.second, points.size() - 1);
    EXPECT_EQ(verdict.closest.distance, distance);
    EXPECT_TRUE(check(points, 1, 1, true, distance, 1).kept);
}

TEST(AMissingPoint, LeavesAHoleOfTheLatticesSpacingThatIsNamed) {
    for (const std::size_t gone : {std::size_t{0}, std::size_t{4321}, std::size_t{9999}}) {
        std::vector<Point> points = square_lattice(kSide);
        const Point hole = points[gone];
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(gone));
        const Verdict verdict = check(points, 1, 1, true, kRadius, 0);
        EXPECT_TRUE(verdict.kept);
        EXPECT_FALSE(verdict.covered);
        EXPECT_NEAR(verdict.emptiest.distance, kSpacing, 4e-12);
        EXPECT_NEAR(verdict.emptiest.at.x, hole.x, 1e-11);
        EXPECT_NEAR(verdict.emptiest.at.y, hole.y, 1e-11);
    }
}

TEST(AHoleInACorner, OfTheBoxIsNamed) {
    std::vector<Point> points = square_lattice(kSide);
    points.pop_back();  // that of the corner (1, 1)
    const Verdict verdict = check(points, 1, 1, false, kRadius, 0);
    EXPECT_FALSE(verdict.covered);
    EXPECT_NEAR(verdict.emptiest.at.x, 1, 1e-11);
    EXPECT_NEAR(verdict.emptiest.at.y, 1, 1e-11);
    EXPECT_NEAR(verdict.emptiest.distance, kSpacing * std::sqrt(2.5), 4e-12);
}

TEST(AGap, WiderByATrifleIsFoundAmongTenThousandOthers) {
    std::vector<Point> points = square_lattice(kSide);
    const double shift = 1e-9;
    // Two neighbours together: the gap left of both grows by shift / (2 sqrt 2). One alone would
    // widen its gaps by the square of the shift only.
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
        const Verdict verdict = check(points, 1, 1, true, 0.1, 0);
        ASSERT_TRUE(verdict.outside.has_value());
        EXPECT_EQ(*verdict.outside, 1U);
        EXPECT_FALSE(verdict.is_maximal());
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

// Snapped to lines, distances hold; gaps narrower than a strip remain, and nearly always some do.
TEST(ASnappedSet, KeepsItsDistancesAndWhereItHasAHoleTheHoleIsReal) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        Request request;
        request.mode = Mode::lines;
        request.radius = 0.02;
        request.snap = true;
        request.boundary = boundary;
        request.backend = "cpu";
        const bool torus = boundary == Boundary::torus;
        const std::vector<Point> points = sample(request).points;
        const Verdict verdict =
            check(points, 1, 1, torus, *request.radius, default_tolerance(1, 1));
        EXPECT_TRUE(verdict.kept);
        EXPECT_FALSE(verdict.covered);
        EXPECT_GT(distance_to_nearest({1, 1, torus}, points, verdict.emptiest.at), 0.02);
        EXPECT_LT(verdict.emptiest.distance, 0.02 * (1 + 1.0 / 30));
    }
}

}  // namespace
}  // namespace lacuna::verify

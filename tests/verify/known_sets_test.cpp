// Given sets that geometry knows all about, the proof finds what it says, on either side of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "verify/sets.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

constexpr double kExactly = 4e-12;  // kFinest in either direction, and some rounding

Verdict check_unit(const std::vector<Point>& points, bool torus, double radius,
                   double tolerance = 0) {
    return check(points, 1, 1, torus, radius, tolerance);
}

TEST(ASquareLattice, OnTheTorusLeavesGapsOfItsHalfDiagonal) {
    const int n = 25;
    const double spacing = 1.0 / n;
    const double gap = spacing * std::numbers::sqrt2 / 2;
    const Verdict verdict = check_unit(square_lattice(n), true, 0.9 * spacing);
    EXPECT_NEAR(verdict.closest.distance, spacing, 1e-15);
    EXPECT_NEAR(verdict.emptiest.distance, gap, kExactly);
    EXPECT_TRUE(verdict.is_maximal());
}

TEST(ASquareLattice, IsCoveredFromItsHalfDiagonalOnAndNotBelow) {
    const double gap = 0.04 * std::numbers::sqrt2 / 2;
    for (const bool torus : {false, true}) {
        EXPECT_TRUE(check_unit(square_lattice(25), torus, gap + kExactly).covered);
        EXPECT_FALSE(check_unit(square_lattice(25), torus, gap - kExactly).covered);
        EXPECT_TRUE(check_unit(square_lattice(25), torus, gap - 1e-9, 1.1e-9).covered);
        EXPECT_FALSE(check_unit(square_lattice(25), torus, gap - 1e-9, 0.9e-9).covered);
    }
}

TEST(AHexagonalLattice, LeavesGapsOfTheCircumcirclesOfItsTriangles) {
    const double row = std::numbers::sqrt3 / 2;
    const std::vector<Point> points = hexagonal_lattice(10, 6, row);
    const Verdict verdict = check(points, 10, 12 * row, true, 0.99, 0);
    EXPECT_NEAR(verdict.closest.distance, 1, 1e-14);
    EXPECT_NEAR(verdict.emptiest.distance, 1 / std::numbers::sqrt3, 12 * kExactly);
    EXPECT_TRUE(verdict.is_maximal());
}

TEST(AHexagonalLattice, OfFlatTrianglesLeavesTheGapsOfTheirCircumcirclesToo) {
    const double row = 0.3;
    const std::vector<Point> points = hexagonal_lattice(10, 20, row);
    // Rows two apart are nearer than the circumcentres of flat triangles assume: spots lie on x of
    // the lattice, as far from a point above as from the two beside.
    const double gap = farthest_of_raster({10, 40 * row, true}, points, 600);
    const Verdict verdict = check(points, 10, 40 * row, true, 0.5, 0);
    EXPECT_GE(verdict.emptiest.distance, gap - 12 * kExactly);
    EXPECT_LE(verdict.emptiest.distance, gap + 12.0 / 600);
    EXPECT_NEAR(verdict.closest.distance, std::hypot(0.5, row), 1e-14);
}

TEST(OnePoint, OnTheUnitTorusIsFarthestFromItsOppositeSpot) {
    const Verdict verdict = check_unit({{0.25, 0.125}}, true, 0.8);
    EXPECT_NEAR(verdict.emptiest.distance, std::numbers::sqrt2 / 2, kExactly);
    EXPECT_NEAR(verdict.emptiest.at.x, 0.75, kExactly);
    EXPECT_NEAR(verdict.emptiest.at.y, 0.625, kExactly);
    EXPECT_TRUE(verdict.is_maximal());
    EXPECT_FALSE(check_unit({{0.25, 0.125}}, true, 0.7).covered);
}

TEST(OnePoint, InABoxIsFarthestFromTheOppositeCorner) {
    const Verdict verdict = check({{Point{0.25, 0.125}}}, 2, 1, false, 2.5, 0);
    EXPECT_NEAR(verdict.emptiest.distance, std::hypot(1.75, 0.875), 2 * kExactly);
    EXPECT_NEAR(verdict.emptiest.at.x, 2, 2 * kExactly);
    EXPECT_NEAR(verdict.emptiest.at.y, 1, 2 * kExactly);
    EXPECT_TRUE(verdict.is_maximal());
}

TEST(NoPoint, KeepsEveryDistanceAndCoversNothing) {
    for (const bool torus : {false, true}) {
        const Verdict verdict = check_unit({}, torus, 5);
        EXPECT_TRUE(verdict.kept);
        EXPECT_FALSE(verdict.covered);
        EXPECT_TRUE(std::isinf(verdict.emptiest.distance));
    }
}

TEST(TwoPoints, AcrossASeamOrACornerAreCloseOnTheTorusOnly) {
    for (const auto& [a, b, wrapped] : {std::tuple{Point{0.01, 0.5}, Point{0.98, 0.5}, 0.03},
                                        std::tuple{Point{0.5, 0.99}, Point{0.5, 0.03}, 0.04},
                                        std::tuple{Point{0.01, 0.02}, Point{0.98, 0.98}, 0.05},
                                        std::tuple{Point{0.01, 0.98}, Point{0.98, 0.02}, 0.05}}) {
        EXPECT_NEAR(check_unit({a, b}, true, 0.1).closest.distance, wrapped, 1e-15);
        EXPECT_FALSE(check_unit({a, b}, true, 0.1).kept);
        EXPECT_TRUE(check_unit({a, b}, false, 0.1).kept);
    }
}

TEST(ATorus, NarrowerThanTheRadiusIsCoveredThroughItsImages) {
    const std::vector<Point> points{{0.5, 0.05}};
    const Verdict verdict = check(points, 1, 0.1, true, 0.6, 0);
    EXPECT_NEAR(verdict.emptiest.distance, std::hypot(0.5, 0.05), kExactly);
    EXPECT_TRUE(verdict.is_maximal());
}

TEST(TheFourCorners, OfABoxLeaveItsMiddleEmptiest) {
    const double high = std::nextafter(1.0, 0.0);
    const std::vector<Point> points{{0, 0}, {high, 0}, {0, high}, {high, high}};
    const Verdict verdict = check_unit(points, false, 0.75);
    EXPECT_NEAR(verdict.emptiest.distance, std::numbers::sqrt2 / 2, kExactly);
    EXPECT_NEAR(verdict.emptiest.at.x, 0.5, kExactly);
    EXPECT_NEAR(verdict.emptiest.at.y, 0.5, kExactly);
    // On the torus they are one spot, but for an ulp.
    EXPECT_EQ(check_unit(points, true, 0.75).closest.distance, 1 - high);
}

}  // namespace
}  // namespace lacuna::verify

// Given sets whose gaps and distances geometry gives, the proof finds the same, and tells a radius
// just above them from a radius just below.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "judge/judge.h"
#include "verify/sets.h"

namespace lacuna::verify {
namespace {

constexpr double kExactly =
    4e-12;  // in units of the domain: kFinest in either direction, and rounding

Proof check_unit(const std::vector<Point>& points, bool torus, double radius,
                 double tolerance = 0) {
    return check(points, 1, 1, torus, radius, tolerance);
}

TEST(ASquareLattice, OnTheTorusLeavesGapsOfItsHalfDiagonal) {
    const int n = 25;
    const double spacing = 1.0 / n;
    const double gap = spacing * std::numbers::sqrt2 / 2;
    const Proof proof = check_unit(square_lattice(n), true, 0.9 * spacing);
    EXPECT_NEAR(proof.least_distance, spacing, 1e-15);
    EXPECT_NEAR(proof.largest_gap_distance, gap, kExactly);
    EXPECT_TRUE(proof.maximal);
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
    const Proof proof = check(points, 10, 12 * row, true, 0.99, 0);
    EXPECT_NEAR(proof.least_distance, 1, 1e-14);
    EXPECT_NEAR(proof.largest_gap_distance, 1 / std::numbers::sqrt3, 12 * kExactly);
    EXPECT_TRUE(proof.maximal);
}

TEST(AHexagonalLattice, OfFlatTrianglesLeavesTheGapsOfTheirCircumcirclesToo) {
    const double row = 0.3;
    const std::vector<Point> points = hexagonal_lattice(10, 20, row);
    // The triangles are so flat that other rows are nearer to their circumcentres. The largest gaps
    // have an x of the lattice, and are as far from a point above as from the two beside.
    const Request torus{.domain = {10, 40 * row, Boundary::torus}};
    const double gap = judge::Judge(torus, points, {}, 0).largest_gap_of_raster(600).room;
    const Proof proof = check(points, 10, 40 * row, true, 0.5, 0);
    EXPECT_GE(proof.largest_gap_distance, gap - 12 * kExactly);
    EXPECT_LE(proof.largest_gap_distance, gap + 12.0 / 600);
    EXPECT_NEAR(proof.least_distance, std::hypot(0.5, row), 1e-14);
}

TEST(OnePoint, OnTheUnitTorusIsFarthestFromItsOppositeSpot) {
    const Proof proof = check_unit({{0.25, 0.125}}, true, 0.8);
    EXPECT_NEAR(proof.largest_gap_distance, std::numbers::sqrt2 / 2, kExactly);
    EXPECT_NEAR(proof.largest_gap.x, 0.75, kExactly);
    EXPECT_NEAR(proof.largest_gap.y, 0.625, kExactly);
    EXPECT_TRUE(proof.maximal);
    EXPECT_FALSE(check_unit({{0.25, 0.125}}, true, 0.7).covered);
}

TEST(OnePoint, InABoxIsFarthestFromTheOppositeCorner) {
    const Proof proof = check({{Point{0.25, 0.125}}}, 2, 1, false, 2.5, 0);
    EXPECT_NEAR(proof.largest_gap_distance, std::hypot(1.75, 0.875), 2 * kExactly);
    EXPECT_NEAR(proof.largest_gap.x, 2, 2 * kExactly);
    EXPECT_NEAR(proof.largest_gap.y, 1, 2 * kExactly);
    EXPECT_TRUE(proof.maximal);
}

TEST(NoPoint, KeepsEveryDistanceAndCoversNothing) {
    for (const bool torus : {false, true}) {
        const Proof proof = check_unit({}, torus, 5);
        EXPECT_TRUE(proof.kept);
        EXPECT_FALSE(proof.covered);
        EXPECT_TRUE(std::isinf(proof.largest_gap_distance));
    }
}

TEST(TwoPoints, AcrossASeamOrACornerAreCloseOnTheTorusOnly) {
    for (const auto& [a, b, wrapped] : {std::tuple{Point{0.01, 0.5}, Point{0.98, 0.5}, 0.03},
                                        std::tuple{Point{0.5, 0.99}, Point{0.5, 0.03}, 0.04},
                                        std::tuple{Point{0.01, 0.02}, Point{0.98, 0.98}, 0.05},
                                        std::tuple{Point{0.01, 0.98}, Point{0.98, 0.02}, 0.05}}) {
        EXPECT_NEAR(check_unit({a, b}, true, 0.1).least_distance, wrapped, 1e-15);
        EXPECT_FALSE(check_unit({a, b}, true, 0.1).kept);
        EXPECT_TRUE(check_unit({a, b}, false, 0.1).kept);
    }
}

TEST(ATorus, NarrowerThanTheRadiusIsCoveredThroughItsImages) {
    const std::vector<Point> points{{0.5, 0.05}};
    const Proof proof = check(points, 1, 0.1, true, 0.6, 0);
    EXPECT_NEAR(proof.largest_gap_distance, std::hypot(0.5, 0.05), kExactly);
    EXPECT_TRUE(proof.maximal);
}

TEST(TheFourCorners, OfABoxLeaveTheirLargestGapInTheMiddle) {
    const double high = std::nextafter(1.0, 0.0);
    const std::vector<Point> points{{0, 0}, {high, 0}, {0, high}, {high, high}};
    const Proof proof = check_unit(points, false, 0.75);
    EXPECT_NEAR(proof.largest_gap_distance, std::numbers::sqrt2 / 2, kExactly);
    EXPECT_NEAR(proof.largest_gap.x, 0.5, kExactly);
    EXPECT_NEAR(proof.largest_gap.y, 0.5, kExactly);
    // On the torus the four corners are nearly one spot: they differ by an ulp.
    EXPECT_EQ(check_unit(points, true, 0.75).least_distance, 1 - high);
}

}  // namespace
}  // namespace lacuna::verify

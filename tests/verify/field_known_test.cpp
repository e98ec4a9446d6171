// Given fields and sets for which one can compute it by hand, the proof finds what geometry says.
#include <gtest/gtest.h>
#include <lacuna/verify.h>

#include <cmath>
#include <string>
#include <vector>

#include "verify/on_field.h"

namespace lacuna::verify {
namespace field_known_test {

// The unit square, whose left half has one radius and whose right half has another.
OnField halves(double left, double right, Boundary boundary = Boundary::box) {
    const auto importance = [](double radius) { return radius == 0 ? 0 : 1 / (radius * radius); };
    return {{2, 1, {importance(left), importance(right)}}, 1, {1, 1, boundary}};
}

TEST(ALargeRadius, CoversASpotOfASmallOneNoFartherThanTheSmallOne) {
    const OnField made = halves(2, 0.1);
    const std::vector<Point> points{{0.25, 0.5}};
    const Proof proof = prove(points, made.claim());
    EXPECT_TRUE(proof.kept);
    EXPECT_FALSE(proof.covered || proof.maximal);
    EXPECT_NEAR(proof.largest_gap.x, 1, 1e-6);
    EXPECT_NEAR(std::abs(proof.largest_gap.y - 0.5), 0.5, 1e-6);
    EXPECT_NEAR(proof.largest_gap_distance, std::hypot(0.75, 0.5), 1e-6);
    EXPECT_NEAR(proof.largest_gap_limit, 0.1, 1e-15);
}

TEST(ASmallRadius, CoversASpotOfALargeOneNoFartherThanItself) {
    const OnField made = halves(2, 0.1);
    const std::vector<Point> points{{0.75, 0.5}};
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.covered);
    EXPECT_NEAR(proof.largest_gap.x, 0, 1e-6);
    EXPECT_NEAR(proof.largest_gap_distance, std::hypot(0.75, 0.5), 1e-6);
    EXPECT_NEAR(proof.largest_gap_limit, 0.1, 1e-15);
}

TEST(TwoPoints, KeepTheSmallerOfTheirRadii) {
    const OnField made = halves(0.2, 0.1);
    const auto is_kept = [&](Point a, Point b) {
        return prove(std::vector<Point>{a, b}, made.claim()).kept;
    };
    EXPECT_TRUE(is_kept({0.45, 0.5}, {0.56, 0.5}));
    EXPECT_FALSE(is_kept({0.45, 0.5}, {0.54, 0.5}));
    EXPECT_FALSE(is_kept({0.2, 0.5}, {0.39, 0.5}));
    EXPECT_TRUE(is_kept({0.2, 0.5}, {0.41, 0.5}));
    // The same around the edges of a torus.
    const OnField wrapped = halves(0.2, 0.1, Boundary::torus);
    EXPECT_FALSE(prove(std::vector<Point>{{0.04, 0.5}, {0.95, 0.5}}, wrapped.claim()).kept);
    EXPECT_TRUE(prove(std::vector<Point>{{0.06, 0.5}, {0.95, 0.5}}, wrapped.claim()).kept);
}

TEST(TheClosestPair, IsTheOneOfTheLeastDistanceForItsLimit) {
    const OnField made = halves(0.2, 0.02);
    const std::vector<Point> points{{0.8, 0.5}, {0.83, 0.5}, {0.1, 0.1}, {0.29, 0.1}};
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.kept);
    EXPECT_EQ(proof.first, 2U);
    EXPECT_EQ(proof.second, 3U);
    EXPECT_EQ(proof.least_distance, 0.29 - 0.1);
    EXPECT_NEAR(proof.least_limit, 0.2, 1e-15);
}

TEST(APointOnABorder, MayBeOnEitherPixel) {
    const OnField made = halves(0.2, 0.1);
    for (const double x : {0.5, 0.5 + 0x1p-29, 0.5 - 0x1p-29}) {
        // For distances the point has the smaller radius, even from a point of the larger one.
        EXPECT_TRUE(prove(std::vector<Point>{{x, 0.5}, {0.39, 0.5}}, made.claim()).kept);
        EXPECT_FALSE(prove(std::vector<Point>{{x, 0.5}, {0.41, 0.5}}, made.claim()).kept);
    }
    // For covering the point has the larger radius: a corner of the left half is 0.707 from it.
    const OnField wide = halves(0.8, 0.6);
    EXPECT_TRUE(prove(std::vector<Point>{{0.5 - 0x1p-20, 0.5}, {0.99, 0}, {0.99, 1}}, wide.claim())
                    .covered);
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}, {0.99, 0}, {0.99, 1}}, wide.claim()).covered);
    EXPECT_FALSE(prove(std::vector<Point>{{0.5 + 0x1p-20, 0.5}, {0.99, 0}, {0.99, 1}}, wide.claim())
                     .covered);
}

TEST(APixelWithoutImportance, MustHaveNoPointAndNeedsNone) {
    const OnField made = halves(2, 0);
    EXPECT_TRUE(prove(std::vector<Point>{{0.25, 0.5}}, made.claim()).maximal);
    EXPECT_FALSE(prove(std::vector<Point>{}, made.claim()).covered);
    const Proof proof = prove(std::vector<Point>{{0.25, 0.5}, {0.75, 0.5}}, made.claim());
    EXPECT_EQ(proof.forbidden, 1U);
    EXPECT_FALSE(proof.kept || proof.covered || proof.maximal);
    // A point very near the border may belong to the left half.
    EXPECT_TRUE(prove(std::vector<Point>{{0.5 + 0x1p-29, 0.5}}, made.claim()).maximal);
    EXPECT_EQ(prove(std::vector<Point>{{0.5 + 0x1p-27, 0.5}}, made.claim()).forbidden, 0U);
    EXPECT_EQ(prove(std::vector<Point>{{0.75, 2}}, made.claim()).outside, 0U);
    // On a torus the right half ends where the left half begins.
    EXPECT_TRUE(prove(std::vector<Point>{{1 - 0x1p-29, 0.5}}, halves(2, 0, Boundary::torus).claim())
                    .maximal);
}

TEST(AFieldWithoutImportance, IsFullFromTheStart) {
    const OnField made = halves(0, 0);
    EXPECT_TRUE(prove(std::vector<Point>{}, made.claim()).maximal);
    EXPECT_EQ(prove(std::vector<Point>{{0.5, 0.5}}, made.claim()).forbidden, 0U);
}

TEST(AFieldsRows, LieFromTheTopDown) {
    const OnField made{{1, 2, {0, 1}}, 2, {1, 3}};
    EXPECT_EQ(prove(std::vector<Point>{{0.5, 2.5}}, made.claim()).forbidden, 0U);
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, made.claim()).maximal);
}

TEST(AnOnlyPixel, ProvesWhatTheUniformProofProves) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        Request request;
        request.radius = 0.02;
        request.domain.width = 1.3;
        request.domain.boundary = boundary;
        std::vector<Point> points = sample(request).points;
        Claim uniform;
        uniform.radius = 0.02;
        uniform.domain = request.domain;
        const Field field{1, 1, {4}};
        Claim claim = uniform;
        claim.field = &field;
        claim.scale = 0.04;
        const Proof all = prove(points, claim);
        EXPECT_TRUE(all.maximal);
        EXPECT_EQ(all.first, prove(points, uniform).first);
        EXPECT_EQ(all.second, prove(points, uniform).second);
        EXPECT_EQ(all.least_distance, prove(points, uniform).least_distance);
        EXPECT_EQ(all.least_limit, 0.02);
        for (const std::size_t gone : {std::size_t{0}, points.size() / 2}) {
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(gone));
            const Proof proof = prove(points, claim);
            const Proof expected = prove(points, uniform);
            EXPECT_FALSE(proof.covered);
            EXPECT_NEAR(proof.largest_gap_distance, expected.largest_gap_distance, 1e-7);
            EXPECT_EQ(proof.largest_gap_limit, 0.02);
        }
    }
}

TEST(AClaim, WithAFieldThatMakesNoSenseIsABadRequestThatNamesTheOption) {
    const auto option_refused = [](const Field& field, double scale, double tolerance = 0) {
        Claim claim;
        claim.field = &field;
        claim.scale = scale;
        claim.tolerance = tolerance;
        try {
            prove(std::vector<Point>{}, claim);
        } catch (const BadRequest& error) {
            return error.option();
        }
        return std::string();
    };
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Field one{1, 1, {1}};
    EXPECT_EQ(option_refused(one, 1), "");
    EXPECT_EQ(option_refused({}, 1), "field");
    EXPECT_EQ(option_refused({2, 1, {1}}, 1), "field");
    for (const double bad : {-1.0, kInfinity, std::nan("")})
        EXPECT_EQ(option_refused({1, 1, {bad}}, 1), "field") << bad;
    for (const double bad : {0.0, -1.0, kInfinity, std::nan(""), 1e-12})
        EXPECT_EQ(option_refused(one, bad), "scale") << bad;
    EXPECT_EQ(option_refused({2, 1, {1, 1e30}}, 1), "scale");
    EXPECT_EQ(option_refused(one, 1, -1), "tolerance");
}

TEST(ATolerance, OverAPercentOfTheLeastRadiusProvesNoSetMaximal) {
    const OnField made = halves(2, 1.5);
    Claim claim = made.claim();
    claim.tolerance = 0.014;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
    claim.tolerance = 0.016;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).covered);
    EXPECT_FALSE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
}

}  // namespace field_known_test
}  // namespace lacuna::verify

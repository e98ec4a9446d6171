// Given points, prove() of the public header says what is true of them.
#include <gtest/gtest.h>
#include <lacuna/verify.h>

#include <atomic>
#include <vector>

#include "judge/plane.h"

namespace {

using namespace lacuna;

TEST(Prove, OfAMaximalSetOfTheSamplersFindsAllThatIsPromised) {
    Request request;
    request.radius = 0.05;
    request.domain.boundary = Boundary::torus;
    request.place.backend = "cpu";
    const Result result = sample(request);
    Claim claim;
    claim.radius = 0.05;
    claim.domain.boundary = Boundary::torus;
    const Proof proof = prove(result.points, claim);
    EXPECT_TRUE(proof.kept && proof.covered && proof.maximal);
    EXPECT_GE(proof.least_distance, 0.05);
    EXPECT_LE(proof.largest_gap_distance, 0.05 + 0x1p-28);
}

TEST(Prove, OfALargeMaximalSetHoldsAndWithoutOneOfItsPointsDoesNot) {
    Request request;
    request.radius = 0.001;
    request.domain.boundary = Boundary::torus;
    request.place.backend = "cpu";
    std::vector<Point> points = sample(request).points;
    EXPECT_GT(points.size(), 690'000U);
    Claim claim;
    claim.radius = 0.001;
    claim.domain = request.domain;
    EXPECT_TRUE(prove(points, claim).maximal);
    const Point gone = points[314'159];
    points.erase(points.begin() + 314'159);
    const Proof proof = prove(points, claim);
    EXPECT_TRUE(proof.kept);
    EXPECT_FALSE(proof.covered);
    EXPECT_LT(judge::distance(request.domain, proof.largest_gap, gone), 0.001);
}

TEST(Prove, OfASetWithAHoleNamesTheSpot) {
    const std::vector<Point> points{{0.25, 0.5}};
    Claim claim;
    claim.radius = 0.7;
    const Proof proof = prove(points, claim);
    EXPECT_TRUE(proof.kept);
    EXPECT_FALSE(proof.covered || proof.maximal);
    EXPECT_NEAR(proof.largest_gap.x, 1, 1e-6);
    EXPECT_NEAR(proof.largest_gap_distance, 0.90138782, 1e-6);
}

TEST(Prove, OfDistancesOnlySaysNothingOfGapsAndNamesThePair) {
    const std::vector<Point> points{{0.1, 0.1}, {0.9, 0.9}, {0.1, 0.2}};
    Claim claim;
    claim.radius = 0.15;
    claim.distances_only = true;
    const Proof proof = prove(points, claim);
    EXPECT_FALSE(proof.kept || proof.covered || proof.maximal);
    EXPECT_EQ(proof.first, 0U);
    EXPECT_EQ(proof.second, 2U);
    claim.radius = 0.1;
    EXPECT_TRUE(prove(points, claim).kept);
}

TEST(Prove, WithAToleranceOverAPercentFindsNoSetMaximal) {
    const std::vector<Point> points{{0.5, 0.5}};
    Claim claim;
    claim.radius = 0.708;
    EXPECT_TRUE(prove(points, claim).maximal);
    claim.tolerance = 0.01;
    EXPECT_TRUE(prove(points, claim).covered);
    EXPECT_FALSE(prove(points, claim).maximal);
}

TEST(Prove, TellsOfAPointOutsideAndRefusesNonsense) {
    const std::vector<Point> points{{1, 1}, {1.5, 0}};
    Claim claim;
    claim.radius = 0.1;
    EXPECT_EQ(prove(points, claim).outside, 1U);
    claim.domain.boundary = Boundary::torus;
    EXPECT_EQ(prove(points, claim).outside, 0U);
    EXPECT_THROW(prove(points, Claim{}), BadRequest);  // has no radius
}

TEST(Prove, IsCancelledAsSoonAsItIsNotWantedAnyMore) {
    Request request;
    request.radius = 0.01;
    const Result result = sample(request);
    Claim claim;
    claim.radius = 0.01;
    for (const bool distances_only : {false, true}) {
        claim.distances_only = distances_only;
        std::atomic<int> asked = 0;
        EXPECT_TRUE(prove(result.points, claim, [&] { return ++asked > 0; }).kept);
        const int whole = asked;
        EXPECT_GT(whole, 2);
        asked = 0;
        EXPECT_THROW(prove(result.points, claim, [&] { return ++asked < 2; }), Cancelled);
        EXPECT_LT(asked, whole);
    }
}

}  // namespace

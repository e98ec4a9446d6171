// Given points, prove() of the public header says what is true of them.
#include <gtest/gtest.h>
#include <lacuna/verify.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include "judge/places_of.h"
#include "judge/plane.h"

namespace {

using namespace lacuna;

TEST(Prove, OfAMaximalSetOfTheSamplersFindsAllThatIsPromised) {
    Request request;
    request.radius = 0.05;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = "cpu";
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
    request.run_on.backend = "cpu";
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

// One point in the middle of the unit square, whose gaps are its corners or those of its border. So
// wide as is promised they are covered, and no wider: docs/exact.md, "Why the set is maximal".
TEST(Prove, AcceptsAGapThatIsOverTheLimitByAsMuchAsIsPromisedAndNoMore) {
    const Point middle{0.5, 0.5};
    const Field even{1, 1, {1}, {}}, round{1, 1, {1}, {Stretch{}}};
    const Mask all{1, 1, {1}};
    const std::vector<PolygonRing> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const std::vector<Point> outside{{1.5, 0.5}};
    const auto classes = [](std::size_t count, double share) {
        return [=](Claim& claim, double limit) {
            claim.radius = 0;
            Classes& made = claim.classes;
            made.names.assign(count, "a");
            made.distances.assign(count * count, share * limit);
            made.distances[0] = limit;
            made.weights.assign(count, 0);
            made.weights[0] = 1;
            static constexpr std::uint8_t kFirst = 0;
            claim.class_of_points = {&kFirst, 1};
        };
    };
    struct Row {
        const char* name;
        double times;  // of 2^-28 of the longer side
        std::function<void(Claim&, double)> add;
        double gap = std::sqrt(0.5);
    };
    const auto follow = [](const Field& field) {
        return [&field](Claim& claim, double limit) {
            claim.field = &field;
            claim.scale = limit;
        };
    };
    for (const Row& row : std::vector<Row>{
             {"one radius", 1, [](Claim&, double) {}},
             {"a field", 2, follow(even)},
             {"ellipses", 2, follow(round)},
             {"a mask", 2, [&](Claim&claim, double) { claim.places.mask = &all; }},
             {"polygons", 2, [&](Claim&claim, double) { claim.places = tests::places_of(square); }},
             {"a border", 2, [](Claim&claim, double) { claim.places.border = 0.25; },
              std::sqrt(0.125)},
             {"a kept point", 2,
              [&](Claim&claim, double) {
                  claim.keep = {&middle, 1};
              }},
             {"a neighbour", 3, [&](Claim&claim, double) { claim.keep = outside; }},
             {"2 classes", 2, classes(2, 1)},
             {"2 classes, 1 to 3", 6, classes(2, 3)},
             {"5 classes", 4, classes(5, 1)},
             {"9 classes, 1 to 3", 24, classes(9, 3)}}) {
        const auto covered = [&](double times) {
            Claim claim;
            claim.radius = row.gap - times * row.times * 0x1p-28;
            row.add(claim, claim.radius);
            const Proof proof = prove({&middle, 1}, claim);
            EXPECT_EQ(proof.tolerance, row.times * 0x1p-28) << row.name;
            return proof.maximal;
        };
        EXPECT_TRUE(covered(0.99)) << row.name;
        EXPECT_FALSE(covered(1.01)) << row.name;
        EXPECT_FALSE(covered(2)) << row.name;
    }
}

// The kept point is rounded to a position that is nearer to the corner by 1.4 units of 2^-30, and
// the radius is rounded up by 3.
TEST(Prove, OfASetAroundAKeptPointAcceptsWhatRoundingLosesWhichIsOverThatOfOneRadius) {
    const double middle = 0.5 + 0.99 * 0x1p-30;
    Request request;
    request.radius = middle * std::sqrt(2.0) - 4.3 * 0x1p-30;
    const std::vector<Point> kept{{middle, middle}};
    request.keep = kept;
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    EXPECT_EQ(result.points, kept);
    Claim claim = claim_of(request, result);
    EXPECT_TRUE(prove(result.points, claim).maximal);
    claim.tolerance = 0x1p-28;
    EXPECT_FALSE(prove(result.points, claim).covered);
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

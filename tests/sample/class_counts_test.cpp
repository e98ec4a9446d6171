// Numbers of points of classes: at the beginning of the same order; proofs. That they are
// exact, on every backend, and the other classes full, is judged by hostile.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "refusal.h"

namespace {

using namespace lacuna;

constexpr std::uint8_t kTrees = 0, kBushes = 1, kGrass = 2;

Request wood() {
    Request request;
    request.classes.names = {"trees", "bushes", "grass"};
    request.classes.distances = distances_by_sum(std::vector<double>{0.04, 0.02, 0.008});
    request.run_on.backend = "cpu";
    request.seed = 5;
    return request;
}

std::uint64_t points_of(std::uint8_t of_class, const Result& set) {
    return static_cast<std::uint64_t>(std::count(set.classes.begin(), set.classes.end(), of_class));
}

void expect_proven(const Request& request, const Result& set) {
    const Proof proof = prove(set.points, claim_of(request, set));
    EXPECT_TRUE(proof.kept && proof.covered && proof.maximal);
}

TEST(CountsOfClasses, OfAllClassesLeaveRoom) {
    Request request = wood();
    request.classes.counts = {5, 6, 7};
    const Result set = sample(request);
    EXPECT_EQ(set.points.size(), 18U);
    EXPECT_FALSE(set.maximal);
    EXPECT_TRUE(claim_of(request, set).distances_only);
}

TEST(CountsOfClasses, IncludeKeptPoints) {
    Request request = wood();
    request.classes.counts = {2, {}, {}};
    const std::vector<Point> keep{{0.5, 0.5}, {0.2, 0.2}};
    const std::vector<std::uint8_t> both_trees{kTrees, kTrees};
    request.keep = keep;
    request.keep_classes = both_trees;
    const Result set = sample(request);
    EXPECT_EQ(points_of(kTrees, set), 2U);
    expect_proven(request, set);
    request.classes.counts = {1, {}, {}};
    EXPECT_EQ(tests::refusal_of([&] { sample(request); }),
              "class trees with 1 points: has 2 kept ones already");
}

TEST(CountsOfClasses, ThatKeptPointsHaveAlreadyLeaveTheSetItsDistances) {
    Request request = wood();
    request.classes.counts = {1, 1, 1};
    const std::vector<Point> keep{{0.5, 0.5}, {0.2, 0.2}, {0.8, 0.2}};
    const std::vector<std::uint8_t> one_each{kTrees, kBushes, kGrass};
    request.keep = keep;
    request.keep_classes = one_each;
    const Result set = sample(request);
    EXPECT_EQ(set.points, keep);
    EXPECT_EQ(set.radius, 0.016);
    EXPECT_EQ(set.backend, "cpu");
    EXPECT_FALSE(set.maximal);
    request.run_on.backend = "nosuch";
    EXPECT_THROW(sample(request), BadRequest);
}

TEST(CountsOfClasses, BesideAClassThatIsNotDrawnLeaveNothingMaximal) {
    Request request = wood();
    request.classes.counts = {2, {}, 3};
    request.classes.weights = {1, 0, 1};
    request.places.borders = {0.01, 0, 0};
    const Result set = sample(request);
    EXPECT_EQ(set.points.size(), 5U);
    EXPECT_FALSE(set.maximal);
    Claim claim = claim_of(request, set);
    claim.distances_only = false;
    EXPECT_FALSE(prove(set.points, claim).maximal);
}

TEST(CountsOfClasses, AreProvenAndRefuted) {
    Request request = wood();
    request.classes.counts = {10, {}, {}};
    Result set = sample(request);
    Claim claim = claim_of(request, set);
    claim.classes.counts = {11, {}, {}};
    EXPECT_EQ(prove(set.points, claim).miscounted, kTrees);
    EXPECT_FALSE(prove(set.points, claim).maximal);

    // Without a blade of grass there is room for one.
    const auto last = std::find(set.classes.rbegin(), set.classes.rend(), kGrass);
    const auto place = set.classes.rend() - last - 1;
    set.points.erase(set.points.begin() + place);
    set.classes.erase(set.classes.begin() + place);
    const Proof without = prove(set.points, claim_of(request, set));
    EXPECT_FALSE(without.covered);
    EXPECT_EQ(without.largest_gap_class, kGrass);

    claim = claim_of(request, set);
    claim.classes.counts = {10};
    EXPECT_EQ(tests::refusal_of([&] { prove(set.points, claim); }),
              "class 1 numbers of points: must be one for each of the 3 classes");
}

// What weights cannot do: as many trees as a set of trees alone has.
TEST(ClassesByPriority, AreFullOneAfterTheOther) {
    Request request = wood();
    const Result by_weight = sample(request);
    request.classes.by_priority = true;
    const Result set = sample(request);
    EXPECT_TRUE(set.maximal);
    EXPECT_TRUE(std::is_sorted(set.classes.begin(), set.classes.end()));
    Request alone = wood();
    alone.classes.weights = {1, 0, 0};
    EXPECT_EQ(points_of(kTrees, set), sample(alone).points.size());
    EXPECT_GT(points_of(kTrees, set), 2 * points_of(kTrees, by_weight));
    expect_proven(request, set);
    // The set by weights is maximal, but not in trees alone.
    Claim claim = claim_of(wood(), by_weight);
    EXPECT_TRUE(prove(by_weight.points, claim).maximal);
    claim.classes.by_priority = true;
    const Proof proof = prove(by_weight.points, claim);
    EXPECT_FALSE(proof.covered);
    EXPECT_EQ(proof.largest_gap_class, kTrees);
}

TEST(ClassesByPriority, EndAtTheirNumbersAndAreProvenBesideKeptPoints) {
    Request request = wood();
    request.classes.by_priority = true;
    request.classes.counts = {12, {}, 30};
    const std::vector<Point> keep{{0.5, 0.5}, {1.01, 0.2}};
    const std::vector<std::uint8_t> grass{kGrass, kGrass};
    request.keep = keep;
    request.keep_classes = grass;
    const Result set = sample(request);
    EXPECT_EQ(points_of(kTrees, set), 12U);
    EXPECT_EQ(points_of(kGrass, set), 30U);
    EXPECT_TRUE(std::is_sorted(set.classes.begin() + 1, set.classes.end()));
    expect_proven(request, set);
}

// Two sizes of trees, then grass: the sizes of a kind are drawn together, and each is full before
// grass begins.
TEST(ClassesByPriority, HaveTheSizesOfAKindTogether) {
    Request request = wood();
    request.classes.names = {"trees", "trees", "grass"};
    request.classes.by_priority = true;
    for (const bool has_numbers : {false, true}) {
        if (has_numbers) request.classes.counts = {5, 9, {}};
        const Result set = sample(request);
        const auto first_grass = std::find(set.classes.begin(), set.classes.end(), kGrass);
        EXPECT_EQ(std::count(first_grass, set.classes.end(), kGrass),
                  set.classes.end() - first_grass);
        EXPECT_FALSE(std::is_sorted(set.classes.begin(), first_grass));
        if (has_numbers) {
            EXPECT_EQ(points_of(kTrees, set), 5U);
            EXPECT_EQ(first_grass - set.classes.begin(), 14);
        }
        expect_proven(request, set);
    }
    // Without the larger trees there is room for smaller ones, beside all grass.
    request.classes.counts.clear();
    const Result set = sample(request);
    Claim claim = claim_of(request, set);
    std::vector<Point> points;
    std::vector<std::uint8_t> kinds;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (set.classes[i] == kTrees) continue;
        points.push_back(set.points[i]);
        kinds.push_back(set.classes[i]);
    }
    claim.class_of_points = kinds;
    EXPECT_FALSE(prove(points, claim).covered);
    request.classes.names = {"trees", "grass", "trees"};
    EXPECT_THROW(sample(request), BadRequest);
}

}  // namespace

// Given sets of ellipses, the proof holds for those that sample() makes, fails with a fault, and
// finds what slow ways find. The slow ways have forms of their own for ellipses.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "verify/ellipse_sets.h"

namespace lacuna::verify {
namespace {

constexpr std::uint64_t kCases = 240;

// The set of a case, made once for all tests.
const std::vector<Point>& set_of(std::uint64_t seed) {
    static const std::vector<std::vector<Point>> sets = [] {
        std::vector<std::vector<Point>> made;
        for (std::uint64_t i = 0; i < kCases; ++i) {
            const EllipseCase asked = ellipse_case(i);
            made.push_back(sample(asked.request(i)).points);
        }
        return made;
    }();
    return sets[seed];
}

std::vector<Point> without(std::vector<Point> points, std::size_t index) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    return points;
}

void expect_the_closest_pair(const EllipseCase& made, std::span<const Point> points,
                             const Proof& proof) {
    if (points.size() < 2) return;
    const Pair closest = made.closest_of_all(points);
    EXPECT_EQ(proof.first, closest.first);
    EXPECT_EQ(proof.second, closest.second);
    EXPECT_EQ(proof.least_distance, closest.distance);
    EXPECT_NEAR(proof.least_distance / proof.least_limit, closest.ratio, 1e-11 * closest.ratio);
    EXPECT_EQ(proof.kept, closest.ratio >= 1);
}

TEST(ASetOfEllipses, IsMaximalAndItsClosestPairIsTheOneOfAllPairs) {
    std::size_t all = 0;
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        const EllipseCase made = ellipse_case(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.name);
        const std::vector<Point>& points = set_of(seed);
        const Proof proof = prove(points, made.claim());
        EXPECT_TRUE(proof.kept && proof.covered && proof.maximal);
        expect_the_closest_pair(made, points, proof);
        EXPECT_LE(made.most_over_of_raster(points, 20), made.tolerance());
        all += points.size();
    }
    EXPECT_GT(all, 20 * kCases);
    EXPECT_LT(all, 300 * kCases);
}

// The spot of the point that is gone is within the tolerance of being covered in hardly any set.
TEST(ASetOfEllipses, WithAPointLessHasAGapThatIsRealAndTheLargest) {
    std::size_t refuted = 0;
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        const EllipseCase made = ellipse_case(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.name);
        std::mt19937_64 random(seed + 1);
        const std::size_t gone = random() % set_of(seed).size();
        const std::vector<Point> points = without(set_of(seed), gone);
        const Proof proof = prove(points, made.claim());
        EXPECT_TRUE(proof.kept);
        if (proof.covered) continue;
        ++refuted;
        EXPECT_FALSE(proof.maximal);
        EXPECT_GT(proof.largest_gap_distance, proof.largest_gap_limit);
        const std::optional<double> over = made.over(points, proof.largest_gap);
        ASSERT_TRUE(over.has_value());
        EXPECT_GT(*over, made.tolerance());
        EXPECT_LE(made.most_over_of_raster(points, 20), *over * (1 + 1e-6));
    }
    EXPECT_GT(refuted, kCases * 99 / 100);
}

TEST(APointMovedIntoAnEllipse, IsNamedWithTheOther) {
    std::size_t refuted = 0;
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        const EllipseCase made = ellipse_case(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.name);
        std::mt19937_64 random(seed + 2);
        std::vector<Point> points = set_of(seed);
        if (points.size() < 2) continue;
        const Point beside = points.front();
        const double angle = any_in(random, 0, 2 * std::numbers::pi);
        const double reach = 0.5 * made.shortest_radius();
        points.back() = {beside.x + reach * std::cos(angle), beside.y + reach * std::sin(angle)};
        if (!made.domain.contains(points.back()) || !made.is_open(points.back())) continue;
        const Proof proof = prove(points, made.claim());
        ++refuted;
        EXPECT_FALSE(proof.kept || proof.maximal);
        expect_the_closest_pair(made, points, proof);
    }
    EXPECT_GT(refuted, kCases / 2);
}

// Ellipses of one shape are disks in a picture that is squeezed along one axis.
TEST(OneEllipseEverywhere, ProvesWhatDisksProveInASqueezedPicture) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        const double root = std::sqrt(any_in(random, 1, 3.9));
        const bool torus = seed % 2 == 0;
        Request request;
        request.domain.width = any_in(random, 1, 3);
        request.domain.height = any_in(random, 1, 3);
        request.domain.boundary = torus ? Boundary::torus : Boundary::box;
        request.radius = 0.12;
        request.seed = seed;
        request.place.backend = "cpu";
        std::vector<Point> disks = sample(request).points;
        if (seed % 4 < 2) disks = without(disks, seed);
        EllipseCase made{"one ellipse", {1, 1, {1}, {{root * root, 0}}}, 0.12};
        made.domain = {request.domain.width * root, request.domain.height / root, torus};
        ASSERT_LT(2 * 0.12 * root, std::min(made.domain.width, made.domain.height));
        std::vector<Point> ellipses;
        ellipses.reserve(disks.size());
        for (const Point point : disks) ellipses.push_back({point.x * root, point.y / root});
        const Field one_pixel{1, 1, {1}, {}};
        Claim of_disks = made.claim();
        of_disks.field = &one_pixel;
        of_disks.domain.width = request.domain.width;
        of_disks.domain.height = request.domain.height;
        of_disks.tolerance = 1e-8;
        Claim of_ellipses = made.claim();
        of_ellipses.tolerance = 1e-8 / root;
        const Proof round = prove(disks, of_disks);
        const Proof stretched = prove(ellipses, of_ellipses);
        EXPECT_EQ(stretched.kept, round.kept);
        EXPECT_EQ(stretched.covered, round.covered);
        EXPECT_EQ(stretched.first, round.first);
        EXPECT_EQ(stretched.second, round.second);
        EXPECT_NEAR(stretched.least_distance / stretched.least_limit, round.least_distance / 0.12,
                    1e-11);
        if (round.covered) continue;
        EXPECT_NEAR(stretched.largest_gap_distance / stretched.largest_gap_limit,
                    round.largest_gap_distance / 0.12, 1e-5);
    }
}

// The unit square, whose left half and right half have ellipses of their own.
EllipseCase halves(double left, Stretch of_left, double right, Stretch of_right) {
    return {"halves", {2, 1, {1 / (left * left), 1 / (right * right)}, {of_left, of_right}}, 1};
}

constexpr double kUpright = std::numbers::pi / 2;

TEST(TwoPoints, AreTooCloseOnlyIfEachLiesInTheOthersEllipse) {
    // Radii of 0.2 and 0.05: lying in the left half, upright in the right one.
    const EllipseCase made = halves(0.1, {4, 0}, 0.1, {4, kUpright});
    const auto is_kept = [&](Point a, Point b) {
        return prove(std::vector<Point>{a, b}, made.claim()).kept;
    };
    EXPECT_FALSE(is_kept({0.1, 0.5}, {0.29, 0.5}));
    EXPECT_TRUE(is_kept({0.1, 0.5}, {0.31, 0.5}));
    EXPECT_TRUE(is_kept({0.1, 0.5}, {0.1, 0.56}));
    EXPECT_FALSE(is_kept({0.8, 0.5}, {0.8, 0.69}));
    EXPECT_TRUE(is_kept({0.8, 0.5}, {0.86, 0.5}));
    // Across the border each way is short for one of the two.
    EXPECT_TRUE(is_kept({0.47, 0.5}, {0.53, 0.5}));
    EXPECT_FALSE(is_kept({0.48, 0.5}, {0.52, 0.5}));
    EXPECT_TRUE(is_kept({0.49, 0.5}, {0.51, 0.56}));
    EXPECT_FALSE(is_kept({0.49, 0.5}, {0.51, 0.54}));
}

TEST(APointOnABorder, MayHaveTheEllipseOfEitherPixel) {
    const EllipseCase made = halves(0.1, {4, 0}, 0.1, {4, kUpright});
    const auto is_kept = [&](double x) {
        return prove(std::vector<Point>{{x, 0.5}, {0.35, 0.5}}, made.claim()).kept;
    };
    EXPECT_FALSE(is_kept(0.5 - 0x1p-20));
    for (const double x : {0.5 - 0x1p-29, 0.5, 0.5 + 0x1p-29, 0.5 + 0x1p-20})
        EXPECT_TRUE(is_kept(x)) << x;
    // A disk of 0.8 reaches the corners at the left, and the thin ellipse does not.
    const EllipseCase wide = halves(0.8, {1, 0}, 0.6, {4, kUpright});
    const auto is_covered = [&](double x) {
        return prove(std::vector<Point>{{x, 0.5}, {0.62, 0.5}, {0.85, 0.5}}, wide.claim()).covered;
    };
    EXPECT_FALSE(is_covered(0.5 + 0x1p-20));
    for (const double x : {0.5 - 0x1p-20, 0.5 - 0x1p-29, 0.5, 0.5 + 0x1p-29})
        EXPECT_TRUE(is_covered(x)) << x;
}

// More points than a list of samples keeps if they cover the same.
TEST(ACrowd, OfEllipsesHidesNoGap) {
    EllipseCase made = ellipse_case(0);
    made.mask.reset();
    std::mt19937_64 random(5);
    const Point middle = any_place(random, made.domain);
    std::vector<Point> points;
    for (int i = 0; i < 3000; ++i) {
        const Point near{middle.x + any_in(random, 0, 1e-3) * made.domain.width,
                         middle.y + any_in(random, 0, 1e-3) * made.domain.height};
        if (made.domain.contains(near) && made.is_open(near)) points.push_back(near);
    }
    ASSERT_GT(points.size(), 2000U);
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.kept || proof.covered);
    const std::optional<double> over = made.over(points, proof.largest_gap);
    ASSERT_TRUE(over.has_value());
    EXPECT_LE(made.most_over_of_raster(points, 15), *over * (1 + 1e-6));
}

TEST(AClaimOfEllipses, ThatMakesNoSenseIsABadRequestThatNamesTheOption) {
    EllipseCase made{"", {1, 1, {1}, {{4, 0}}}, 0.2};
    const auto option_refused = [&]() -> std::string {
        try {
            prove({}, made.claim());
        } catch (const BadRequest& error) {
            return error.option();
        }
        return "";
    };
    EXPECT_EQ(option_refused(), "");
    made.field.stretches = {{0.5, 0}};
    EXPECT_EQ(option_refused(), "stretches");
    made.field.stretches = {{2, std::nan("")}};
    EXPECT_EQ(option_refused(), "stretches");
    made.field.stretches = {{2, 0}, {2, 0}};
    EXPECT_EQ(option_refused(), "stretches");
    made.field.stretches = {{4, 0}};
    made.domain.torus = true;
    EXPECT_EQ(option_refused(), "");
    made.scale = 0.26;  // the ellipse is 1.04 long
    EXPECT_EQ(option_refused(), "torus");
}

}  // namespace
}  // namespace lacuna::verify

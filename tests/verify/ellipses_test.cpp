// Given sets of ellipses for which one can compute it by hand, the proof finds what geometry says.
// Random sets are judged by hostile.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "fields.h"
#include "judge/judge.h"
#include "verify/on_field.h"

namespace lacuna::verify {
namespace {

std::vector<Point> without(std::vector<Point> points, std::size_t index) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    return points;
}

// Ellipses of one shape are disks in a picture that is squeezed along one axis.
TEST(OneEllipseEverywhere, ProvesWhatDisksProveInASqueezedPicture) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        const double root = std::sqrt(judge::any_in(random, 1, 3.9));
        Request request;
        request.domain = {judge::any_in(random, 1, 3), judge::any_in(random, 1, 3),
                          seed % 2 == 0 ? Boundary::torus : Boundary::box};
        request.radius = 0.12;
        request.seed = seed;
        request.run_on.backend = "cpu";
        std::vector<Point> disks = sample(request).points;
        if (seed % 4 < 2) disks = without(disks, seed);
        OnField made{{1, 1, {1}, {{root * root, 0}}}, 0.12, request.domain};
        made.domain.width *= root;
        made.domain.height /= root;
        ASSERT_LT(2 * 0.12 * root, made.domain.shorter_side());
        std::vector<Point> ellipses;
        ellipses.reserve(disks.size());
        for (const Point point : disks) ellipses.push_back({point.x * root, point.y / root});
        const Field one_pixel{1, 1, {1}, {}};
        Claim of_disks = made.claim();
        of_disks.field = &one_pixel;
        of_disks.domain = request.domain;
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
OnField halves(double left, Stretch of_left, double right, Stretch of_right) {
    return {{2, 1, {1 / (left * left), 1 / (right * right)}, {of_left, of_right}}};
}

constexpr double kUpright = std::numbers::pi / 2;

TEST(TwoPoints, AreTooCloseOnlyIfEachLiesInTheOthersEllipse) {
    // Radii of 0.2 and 0.05: lying in the left half, upright in the right one.
    const OnField made = halves(0.1, {4, 0}, 0.1, {4, kUpright});
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
    const OnField made = halves(0.1, {4, 0}, 0.1, {4, kUpright});
    const auto is_kept = [&](double x) {
        return prove(std::vector<Point>{{x, 0.5}, {0.35, 0.5}}, made.claim()).kept;
    };
    EXPECT_FALSE(is_kept(0.5 - 0x1p-20));
    for (const double x : {0.5 - 0x1p-29, 0.5, 0.5 + 0x1p-29, 0.5 + 0x1p-20})
        EXPECT_TRUE(is_kept(x)) << x;
    // A disk of 0.8 reaches the corners at the left, and the thin ellipse does not.
    const OnField wide = halves(0.8, {1, 0}, 0.6, {4, kUpright});
    const auto is_covered = [&](double x) {
        return prove(std::vector<Point>{{x, 0.5}, {0.62, 0.5}, {0.85, 0.5}}, wide.claim()).covered;
    };
    EXPECT_FALSE(is_covered(0.5 + 0x1p-20));
    for (const double x : {0.5 - 0x1p-20, 0.5 - 0x1p-29, 0.5, 0.5 + 0x1p-29})
        EXPECT_TRUE(is_covered(x)) << x;
}

// More points than a list of samples keeps if they cover the same.
TEST(ACrowd, OfEllipsesHidesNoGap) {
    const OnField made{
        tests::stretched_at_random(tests::sizes_field(7, 6, 3), 32, 4), 0.1, {2, 1.5}};
    std::mt19937_64 random(5);
    const Point middle = judge::any_place(random, made.domain);
    std::vector<Point> points;
    for (int i = 0; i < 3000; ++i) {
        const Point near{middle.x + judge::any_in(random, 0, 1e-3) * made.domain.width,
                         middle.y + judge::any_in(random, 0, 1e-3) * made.domain.height};
        if (made.domain.holds(near)) points.push_back(near);
    }
    ASSERT_GT(points.size(), 2000U);
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.kept || proof.covered);
    Request request{.domain = made.domain};
    request.field = &made.field;
    const judge::Judge judge(request, points, {}, made.scale);
    EXPECT_LE(judge.largest_gap_of_raster(15).room, judge.room(proof.largest_gap) * (1 + 1e-6));
}

TEST(AClaimOfEllipses, ThatMakesNoSenseIsABadRequestThatNamesTheOption) {
    OnField made{{1, 1, {1}, {{4, 0}}}, 0.2};
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
    made.domain.boundary = Boundary::torus;
    EXPECT_EQ(option_refused(), "");
    made.scale = 0.26;  // the ellipse is 1.04 long
    EXPECT_EQ(option_refused(), "torus");
}

}  // namespace
}  // namespace lacuna::verify

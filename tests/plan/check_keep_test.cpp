// Kept points that are too close to each other are named.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "judge/judge.h"
#include "plan/kept.h"
#include "refusal.h"

namespace {

using namespace lacuna;

std::string refusal_of(const Request& request) {
    return tests::refusal_of([&] { check_kept_distances(request); });
}

TEST(KeptPoints, OfTheSamePlaceAreNamedHoweverMany) {
    Request request;
    request.radius = 1e-4;
    const std::vector<Point> keep(1'000'000, Point{0.5, 0.5});
    request.keep = keep;
    EXPECT_NE(refusal_of(request).find("are 0 apart"), std::string::npos);
}

TEST(KeptPoints, KeepTheSmallerOfTheirRadii) {
    Request request;
    const Field field{2, 1, {1, 1.0 / 256}};  // radii of 1/64 to the left and 1/4 to the right
    request.field = &field;
    request.scale = 1.0 / 64;
    const std::vector<Point> fine{{0.484375, 0.5}, {0.53125, 0.5}, {0.78125, 0.5}};
    request.keep = fine;
    EXPECT_EQ(refusal_of(request), "accepted");
    const std::vector<Point> close{{0.484375, 0.5}, {0.53125, 0.5}, {0.75, 0.5}};
    request.keep = close;
    EXPECT_EQ(
        refusal_of(request),
        "keep point 1 at (0.53125, 0.5) and point 2 at (0.75, 0.5): are 0.21875 apart: must be "
        "at least 0.25, the smaller of their radii");
}

TEST(KeptPoints, OnTheBorderOfTwoPixelsMayHaveTheRadiusOfEither) {
    Request request;
    const Field field{2, 1, {1, 1.0 / 256}};
    request.field = &field;
    request.scale = 1.0 / 64;
    const std::vector<Point> keep{{0.5, 0.5}, {0.5625, 0.5}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request), "accepted");
}

// Compared with a check of every pair.
TEST(KeptPoints, AreRefusedWhereAnyPairIsTooClose) {
    std::mt19937_64 random(18);
    std::uniform_real_distribution<double> anywhere(0, 1);
    int refused = 0;
    for (int turn = 0; turn < 400; ++turn) {
        Field field{8, 8, {}};
        for (int i = 0; i < 64; ++i)
            field.importance.push_back(std::exp2(std::floor(20 * anywhere(random)) - 20));
        Request request;
        request.field = &field;
        request.scale = 0.004;
        request.domain.boundary = turn % 2 == 0 ? Boundary::box : Boundary::torus;
        std::vector<Point> keep;
        for (int i = 2 + turn % 6; i > 0; --i) keep.push_back({anywhere(random), anywhere(random)});
        request.keep = keep;
        const bool is_too_close = judge::Judge(request, keep, {}, 0.004).closest().share < 1;
        EXPECT_EQ(refusal_of(request) != "accepted", is_too_close) << "turn " << turn;
        refused += is_too_close ? 1 : 0;
    }
    EXPECT_GT(refused, 50);
    EXPECT_LT(refused, 350);
}

// Many points in the domain and around it, at a radius just below and just above that at which two
// of them are too close.
TEST(KeptPoints, MayHaveTheRadiusThatTheClosestPairAllows) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(-2, 2);
    for (int turn = 0; turn < 100; ++turn) {
        Request request;
        const bool is_torus = turn % 2 == 1;
        if (is_torus) request.domain = {3, 2, Boundary::torus};
        if (turn % 4 >= 2)
            request.classes = {.names = {"a", "b", "c"},
                               .distances = {1, 0, 30, 0, 2, 3, 30, 3, 9}};
        const std::size_t classes = std::max<std::size_t>(1, request.classes.names.size());
        std::vector<Point> keep;
        std::vector<std::uint8_t> kinds;
        for (int i = 0; i < 200; ++i) {
            const Point point{anywhere(random), anywhere(random)};
            keep.push_back(is_torus ? Point{std::abs(point.x), std::abs(point.y) / 2} : point);
            kinds.push_back(static_cast<std::uint8_t>(static_cast<std::size_t>(i) % classes));
        }
        request.keep = keep;
        if (classes > 1) request.keep_classes = kinds;
        // Each lies in a domain of all, and the least distance of two classes is 1.
        Request all{.domain = request.domain};
        all.classes = request.classes;
        const double most =
            judge::Judge(all, keep, request.keep_classes, 1).closest().share;  // radius
        request.radius = most * (1 - 1e-12);
        EXPECT_EQ(refusal_of(request), "accepted") << "turn " << turn;
        request.radius = most * (1 + 1e-12);
        EXPECT_NE(refusal_of(request), "accepted") << "turn " << turn;
    }
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// Two classes, each crowded far outside of the domain, as far from the other as these two must be.
TEST(KeptPoints, AreComparedInAShortTimeWhereverTheyLieAndHoweverDistancesDiffer) {
    constexpr int kSide = 400;
    Request request;
    request.classes = {.names = {"a", "b"}, .distances = {0.001, 1, 1, 0.001}};
    request.radius = 0.001;
    std::vector<Point> keep;
    std::vector<std::uint8_t> kinds;
    for (int kind = 0; kind < 2; ++kind)
        for (int x = 0; x < kSide; ++x)
            for (int y = 0; y < kSide; ++y) {
                keep.push_back({-5 + x * 0.0011, -5 + kind * 1.5 + y * 0.0011});
                kinds.push_back(static_cast<std::uint8_t>(kind));
            }
    request.keep = keep;
    request.keep_classes = kinds;
    const double begin = processor_seconds();
    EXPECT_EQ(refusal_of(request), "accepted");
    EXPECT_LT(processor_seconds() - begin, 5);  // each with each takes a minute
}

// Samples are rounded over the seam of a torus, as over other borders of pixels.
TEST(KeptPoints, AtTheSeamOfATorusCountForThePixelsBeyondIt) {
    const double last = std::nextafter(1, 0), near = 1 - 0x1p-29;
    const Field left{4, 1, {1, 0, 0, 0}}, corner{2, 2, {0, 0, 1, 0}};
    const Mask mask{4, 1, {1, 0, 0, 0}, {}, {}};
    for (const auto& [open, at] :
         {std::pair{left, Point{last, 0.5}}, {left, {near, 0.5}}, {corner, {near, last}}})
        for (const double ratio : {0.0, 1.0, 1.5}) {  // 0: the mask without a field
            Field field = open;
            if (ratio > 1) field.stretches.assign(4, {ratio, 0.3});
            const std::vector<Point> keep{at};
            Request request{.domain = {1, 1, Boundary::torus}, .field = &field, .scale = 0.1};
            if (ratio == 0) request = {.domain = request.domain, .radius = 0.1};
            if (ratio == 0) request.places.mask = &mask;
            request.keep = keep;
            const Result made = sample(request);
            EXPECT_EQ(made.points.front(), at);
            EXPECT_TRUE(prove(made.points, claim_of(request, made)).maximal);
            request.domain.boundary = Boundary::box;
            EXPECT_THROW(sample(request), BadRequest);
        }
}

}  // namespace

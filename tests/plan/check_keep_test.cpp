// Kept points that are too close to each other are named.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "plan/kept.h"
#include "refusal.h"

namespace {

using namespace lacuna;

std::string refusal_of(const Request& request) {
    return tests::refusal_of([&] { check_kept_distances(request); });
}

TEST(KeptPoints, ThatAreTooCloseAreNamed) {
    Request request;
    request.radius = 0.25;
    const std::vector<Point> keep{{0.75, 0.5}, {0.25, 0.5}, {0.5, 0.5}, {0.5, 0.625}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request),
              "keep point 2 at (0.5, 0.5) and point 3 at (0.5, 0.625): are 0.125 apart: must be at "
              "least 0.25, the radius");
    request.keep = std::span(keep).first(3);
    EXPECT_EQ(refusal_of(request), "accepted");
}

TEST(KeptPoints, AreComparedAroundTheEdgesOfATorus) {
    Request request;
    request.radius = 0.25;
    const std::vector<Point> keep{{0.0625, 0.5}, {0.9375, 0.5}};
    request.keep = keep;
    EXPECT_EQ(refusal_of(request), "accepted");
    request.domain.boundary = Boundary::torus;
    EXPECT_EQ(
        refusal_of(request),
        "keep point 0 at (0.0625, 0.5) and point 1 at (0.9375, 0.5): are 0.125 apart: must be "
        "at least 0.25, the radius");
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
        const auto radius_at = [&](Point point) {
            const auto row = static_cast<std::size_t>(7 - std::floor(8 * point.y));
            const auto column = static_cast<std::size_t>(std::floor(8 * point.x));
            return *request.scale / std::sqrt(field.importance[8 * row + column]);
        };
        bool is_too_close = false;
        for (std::size_t a = 0; a < keep.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                double dx = std::abs(keep[a].x - keep[b].x);
                double dy = std::abs(keep[a].y - keep[b].y);
                if (turn % 2 == 1) {
                    dx = std::min(dx, 1 - dx);
                    dy = std::min(dy, 1 - dy);
                }
                is_too_close |=
                    std::hypot(dx, dy) < std::min(radius_at(keep[a]), radius_at(keep[b]));
            }
        EXPECT_EQ(refusal_of(request) != "accepted", is_too_close) << "turn " << turn;
        refused += is_too_close ? 1 : 0;
    }
    EXPECT_GT(refused, 50);
    EXPECT_LT(refused, 350);
}

}  // namespace

// The promises of lacuna.h for mode exact, seen from outside: distances in double and the m of the
// result.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

#include "distances.h"

namespace exact_promises_test {

using namespace lacuna;

Request request_of(double radius, Mode mode = Mode::exact) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.place.backend = "cpu";
    return request;
}

TEST(ADefaultRequest, IsExactAndMaximal) {
    Request request;
    request.radius = 0.05;
    EXPECT_EQ(request.mode, Mode::exact);
    const Result result = sample(request);
    EXPECT_TRUE(result.maximal);
    EXPECT_EQ(result.points, sample(request_of(0.05)).points);
    EXPECT_NE(result.points, sample(request_of(0.05, Mode::lines)).points);
}

TEST(AResult, TellsTheLinesPerRadiusAskedForOrTheModesOwn) {
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        for (const std::uint32_t m : {1u, 6u, 17u, 30u, 1000u}) {
            Request request = request_of(0.1, mode);
            request.paper2011.lines_per_radius = m;
            EXPECT_EQ(sample(request).lines_per_radius, m);
        }
    }
    EXPECT_EQ(sample(request_of(0.1, Mode::exact)).lines_per_radius, 6u);
    EXPECT_EQ(sample(request_of(0.1, Mode::lines)).lines_per_radius, 30u);

    Request told = request_of(0.1, Mode::exact);
    told.paper2011.lines_per_radius = 6;
    EXPECT_EQ(sample(told).points, sample(request_of(0.1, Mode::exact)).points);
}

TEST(ALargeExactSet, KeepsTheRadiusInDoubleAndComesCloseToIt) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        for (const std::uint32_t m : {1u, 3u, 6u, 30u}) {
            Request request = request_of(0.005);
            request.domain.boundary = boundary;
            request.paper2011.lines_per_radius = m;
            const double least =
                tests::least_distance(sample(request).points, 1, 1, boundary == Boundary::torus);
            EXPECT_GE(least, 0.005);
            EXPECT_LT(least, 0.005 * 1.0001);
        }
    }
}

// Sides, radii and units that are no round numbers.
TEST(AnyExactSet, KeepsTheRadiusInDoubleAndItsPointsInTheDomain) {
    constexpr std::uint64_t kSeed = 6;
    constexpr int kSets = 300;
    std::printf("seed %lu\n", kSeed);
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> side(0.1, 3);
    std::uniform_real_distribution<double> share(0.1, 1);
    double closest = 10;  // least distance over radius
    for (int i = 0; i < kSets; ++i) {
        Request request;
        request.place.backend = "cpu";
        request.domain.width = side(random) / 7919;
        request.domain.height = side(random) / 7919;
        request.radius = request.domain.shorter_side() * share(random) * share(random);
        request.domain.boundary = random() % 2 == 0 ? Boundary::box : Boundary::torus;
        request.paper2011.lines_per_radius = static_cast<std::uint32_t>(1 + random() % 60);
        request.seed = random();
        const bool torus = request.domain.wraps();
        const Result result = sample(request);
        const double least = tests::least_distance(result.points, request.domain.width,
                                                   request.domain.height, torus);
        ASSERT_GE(least, *request.radius) << "set " << i;
        closest = std::min(closest, least / *request.radius);
        for (const Point point : result.points) {
            ASSERT_TRUE(point.x >= 0 && point.x < request.domain.width) << "set " << i;
            ASSERT_TRUE(point.y >= 0 && point.y < request.domain.height) << "set " << i;
        }
    }
    EXPECT_LT(closest, 1.0001);
}

// At m = 1 one strip is the whole domain, and the radius, rounded up, a unit more.
TEST(ATorus, AsWideAsTheRadiusHoldsOnePointAtAnyM) {
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        for (const std::uint32_t m : {1u, 2u, 3u, 60u}) {
            Request request = request_of(1, mode);
            request.domain.boundary = Boundary::torus;
            request.paper2011.lines_per_radius = m;
            EXPECT_EQ(sample(request).points.size(), 1u) << name_of(mode) << ", m " << m;
        }
    }
}

TEST(APrefix, OfAnExactSetIsWhatALimitGives) {
    const std::vector<Point> all = sample(request_of(0.02)).points;
    for (const std::uint64_t limit : {std::uint64_t{1}, std::uint64_t{700}, all.size() - 1}) {
        Request request = request_of(0.02);
        request.limit = limit;
        const Result result = sample(request);
        ASSERT_EQ(result.points.size(), limit);
        EXPECT_TRUE(std::equal(result.points.begin(), result.points.end(), all.begin()));
        EXPECT_FALSE(result.maximal);
    }
}

TEST(TheModes, AreNamedAsTheCommandNamesThem) {
    EXPECT_EQ(name_of(Mode::exact), "exact");
    EXPECT_EQ(name_of(Mode::lines), "lines");
}

}  // namespace exact_promises_test

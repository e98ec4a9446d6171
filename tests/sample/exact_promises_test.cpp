// The promises of lacuna.h for mode exact, seen from outside: distances in double and the m of the
// result.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

#include "judge/plane.h"

namespace exact_promises_test {

using namespace lacuna;

Request request_of(double radius, Mode mode = Mode::exact) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.run_on.backend = "cpu";
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
}

TEST(ALargeExactSet, KeepsTheRadiusInDoubleAndComesCloseToIt) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        for (const std::uint32_t m : {1u, 3u, 6u, 30u}) {
            Request request = request_of(0.005);
            request.domain.boundary = boundary;
            request.paper2011.lines_per_radius = m;
            const double least =
                judge::closest_pair(request.domain, sample(request).points).distance;
            EXPECT_GE(least, 0.005);
            EXPECT_LT(least, 0.005 * 1.0001);
        }
    }
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

TEST(TheModes, AreNamedAsTheCommandNamesThem) {
    EXPECT_EQ(name_of(Mode::exact), "exact");
    EXPECT_EQ(name_of(Mode::lines), "lines");
}

}  // namespace exact_promises_test

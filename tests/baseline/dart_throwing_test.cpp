// Dart throwing: distances, coverage, and its end after many misses.
#include "baseline/dart_throwing.h"

#include <gtest/gtest.h>

#include "plan/make_plan.h"
#include "portable/distance.h"

namespace {

using namespace lacuna;

Plan plan_of(double radius, Boundary boundary, double width = 1) {
    Request request;
    request.radius = radius;
    request.domain.boundary = boundary;
    request.domain.width = width;
    request.seed = 7;
    return make_plan(request);
}

std::size_t conflicts_among(const Plan& plan, const std::vector<Sample>& samples) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            count += portable::are_closer(samples[i].x, samples[i].y, samples[j].x, samples[j].y,
                                          plan.period_x, plan.period_y, plan.radius_squared);
    return count;
}

TEST(DartThrowing, KeepsEveryDistance) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        for (const double radius : {0.02, 0.07, 0.4, 0.9}) {
            const Plan plan = plan_of(radius, boundary, 1.3);
            EXPECT_EQ(conflicts_among(plan, baseline::throw_darts(plan, 1000).samples), 0u);
        }
    }
}

TEST(DartThrowing, ComesNearAMaximalSetButNotThere) {
    const Plan plan = plan_of(0.01, Boundary::torus);
    const double maximal = expected_count({1, 1, Boundary::torus}, 0.01);
    const auto count = static_cast<double>(baseline::throw_darts(plan, 10'000).samples.size());
    EXPECT_GT(count, 0.90 * maximal);
    EXPECT_LT(count, 0.96 * maximal);
}

TEST(DartThrowing, StopsAfterItsMissesInARow) {
    const Plan plan = plan_of(1, Boundary::torus);  // the first dart leaves no room
    const baseline::Darts darts = baseline::throw_darts(plan, 10);
    EXPECT_EQ(darts.samples.size(), 1u);
    EXPECT_EQ(darts.thrown, 11u);
}

TEST(DartThrowing, StopsAtTheLimit) {
    Plan plan = plan_of(0.01, Boundary::box);
    plan.limit = 123;
    EXPECT_EQ(baseline::throw_darts(plan, 1000).samples.size(), 123u);
}

}  // namespace

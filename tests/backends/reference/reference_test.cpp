// The reference sampler: in lines, distances and maximality on the lines; in both modes,
// determinism and limits. That exact sets are maximal is shown in tests/verify.
#include "backends/reference/reference.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "judge/plane.h"
#include "plan/make_plan.h"
#include "portable/distance.h"

namespace {

using namespace lacuna;

Outcome run(const Request& request) {
    Observer nobody;
    return reference::sample(make_plan(request), nobody);
}

// Checks by brute force over every line and every sample that no y of a line is left uncovered. The
// covered stretches of a line are sorted and joined, apart from the spans that the sampler keeps.
bool every_line_is_covered(const Plan& plan, const std::vector<Sample>& samples) {
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        std::vector<std::pair<std::int64_t, std::int64_t>> covered;
        for (const Sample& sample : samples) {
            // The 64 bits of a long double hold the squares exactly.
            const long double dx =
                portable::axis_distance(sample.x, plan.centre_of_line(line), plan.period_x);
            const long double r = plan.radius;
            if (dx >= r) continue;
            const auto half = static_cast<std::int64_t>(std::ceil(std::sqrt(r * r - dx * dx))) - 1;
            for (const std::int64_t image : {-1, 0, 1}) {
                if (image != 0 && plan.period_y == 0) continue;
                const std::int64_t y = sample.y + image * std::int64_t{plan.height};
                covered.emplace_back(y - half, y + half);
            }
        }
        std::sort(covered.begin(), covered.end());
        std::int64_t next_free = 0;
        for (const auto& [low, high] : covered)
            if (low <= next_free) next_free = std::max(next_free, high + 1);
        if (next_free < plan.height) return false;
    }
    return true;
}

double least_distance_of(const Request& request) {
    return judge::closest_pair(request.domain, sample(request).points).distance;
}

Request small_request() {
    Request request;
    request.mode = Mode::lines;
    request.domain.width = *rc::gen::inRange(50, 201) / 100.0;
    request.domain.height = *rc::gen::inRange(50, 201) / 100.0;
    request.domain.boundary = *rc::gen::element(Boundary::box, Boundary::torus);
    request.paper2011.lines_per_radius = *rc::gen::inRange(1u, 61u);
    request.paper2011.snap = *rc::gen::arbitrary<bool>();
    request.paper2011.uniform_x = *rc::gen::arbitrary<bool>();
    request.paper2011.round_size =
        request.paper2011.uniform_x ? 1 : *rc::gen::element(0u, 1u, 2u, 7u, 1000u);
    request.seed = *rc::gen::arbitrary<std::uint64_t>();
    request.radius = *rc::gen::inRange(5, 51) / 100.0;
    request.run_on.backend = "reference";
    return request;
}

RC_GTEST_PROP(Reference, KeepsItsDistancesAndCoversEveryLine, ()) {
    const Request request = small_request();
    const Plan plan = make_plan(request);
    const std::vector<Sample> samples = run(request).samples;
    RC_ASSERT(!samples.empty());
    RC_ASSERT(every_line_is_covered(plan, samples));

    const double kept = request.paper2011.snap ? 1 : 1 - 0.5 / *request.paper2011.lines_per_radius;
    const double least = least_distance_of(request);
    RC_ASSERT(least >= *request.radius * kept);
    if (!request.paper2011.snap) return;
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            RC_ASSERT(!portable::are_closer(samples[i].x, samples[i].y, samples[j].x, samples[j].y,
                                            plan.period_x, plan.period_y, plan.radius_squared));
}

TEST(Reference, CoverageCheckSeesOneMissingSample) {
    Request request;
    request.mode = Mode::lines;
    request.radius = 0.1;
    const Plan plan = make_plan(request);
    std::vector<Sample> samples = run(request).samples;
    ASSERT_TRUE(every_line_is_covered(plan, samples));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<Sample> others = samples;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_FALSE(every_line_is_covered(plan, others)) << i;
    }
}

TEST(Reference, KeepsItsDistancesInALargeSet) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        for (const bool snap : {false, true}) {
            Request request;
            request.mode = Mode::lines;
            request.radius = 0.005;
            request.domain.boundary = boundary;
            request.paper2011.snap = snap;
            request.run_on.backend = "reference";
            const double least = least_distance_of(request);
            EXPECT_GE(least, snap ? 0.005 : 0.005 * (1 - 1.0 / 60));
            EXPECT_LT(least, 0.005 * 1.001);
        }
    }
}

TEST(Reference, InterpolatedDistancesDoFallBelowTheRadius) {
    // The paper's approximation, and the reason for --snap: if this fails, x is not interpolated.
    Request request;
    request.mode = Mode::lines;
    request.radius = 0.01;
    request.run_on.backend = "reference";
    EXPECT_LT(least_distance_of(request), 0.00995);
}

Request request_of(Mode mode, double radius) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.run_on.backend = "reference";
    return request;
}

class ReferenceInMode : public testing::TestWithParam<Mode> {};

TEST_P(ReferenceInMode, ACountIsMetExactly) {
    for (const std::uint64_t count : {1u, 2u, 3u, 10u, 278u, 5000u}) {
        for (const std::uint32_t m : {1u, 30u}) {
            for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
                Request request;
                request.mode = GetParam();
                request.count = count;
                request.domain.boundary = boundary;
                request.paper2011.lines_per_radius = m;
                request.paper2011.snap = request.mode == Mode::lines;
                request.run_on.backend = "reference";
                const Result result = sample(request);
                EXPECT_EQ(result.points.size(), count);
                const double least = judge::closest_pair(request.domain, result.points).distance;
                EXPECT_GE(least, result.radius);
                // Not too small: within a tenth of the maximal set's density.
                if (count > 1000 && (m == 30 || request.mode == Mode::exact)) {
                    EXPECT_LT(expected_count({1, 1, boundary}, result.radius),
                              1.1 * static_cast<double>(count));
                }
            }
        }
    }
}

TEST_P(ReferenceInMode, ARadiusOfTheWholeDomainGivesOneSample) {
    Request request = request_of(GetParam(), 1.41421);
    EXPECT_EQ(sample(request).points.size(), 1u);
    request.domain.boundary = Boundary::torus;
    request.radius = 1;
    EXPECT_EQ(sample(request).points.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Each, ReferenceInMode, testing::Values(Mode::exact, Mode::lines),
                         [](const auto& test) { return std::string(name_of(test.param)); });

}  // namespace

// Rounds with more draws than samples fit: most draws conflict with others of their round, and
// comparing all pairs would take for ever.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/requests.h"
#include "fields.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

class Crowd : public tests::OnBackend {
protected:
    void expect_as_the_reference(Request request) const {
        SCOPED_TRACE(tests::describe(request));
        const Plan plan = make_plan(request);
        Observer nobody;
        request.place.backend = "reference";
        const Outcome expected = run_on_backend(request, plan, nobody).outcome;
        request.place.backend = GetParam();
        const Outcome got = run_on_backend(request, plan, nobody).outcome;
        EXPECT_EQ(got.rounds, expected.rounds);
        EXPECT_EQ(got.draws, expected.draws);
        EXPECT_TRUE(got.samples == expected.samples)
            << got.samples.size() << " samples, of " << expected.samples.size();
    }
};

Request crowded(Mode mode, double radius, std::uint64_t round_size, Boundary boundary) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.paper2011.round_size = round_size;
    request.domain.boundary = boundary;
    request.seed = round_size;
    return request;
}

// Dark and light halves side by side, from the bottom to the top.
Field halves(double importance) {
    return tests::made_field(2, 8, [&](double x, double) { return x < 0.5 ? 1 : importance; });
}

TEST_P(Crowd, OfALargeRadiusIsServedAsByTheReference) {
    for (const Mode mode : {Mode::exact, Mode::lines})
        for (const Boundary boundary : {Boundary::box, Boundary::torus})
            for (const double radius : {0.5, 0.12, 0.03})
                expect_as_the_reference(crowded(mode, radius, 20'000, boundary));
}

TEST_P(Crowd, OfPlacesThatAreAlmostFullIsServedAsByTheReference) {
    for (const std::uint32_t m : {1u, 40u}) {
        Request request = crowded(Mode::exact, 0.2, 5'000, Boundary::torus);
        request.paper2011.lines_per_radius = m;
        expect_as_the_reference(request);
        request.mode = Mode::lines;
        request.domain.width = 30;
        expect_as_the_reference(request);
    }
}

TEST_P(Crowd, OfALightPlaceBesideADarkOneIsServedAsByTheReference) {
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
        for (const double importance : {1e-2, 1e-4, 1e-8}) {
            for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
                tests::CellsRequest made = tests::cells_request("halves", halves(importance), 2'000,
                                                                4, metric, boundary, 1, 4);
                expect_as_the_reference(made.request);
                made.request.paper2011.round_size = 20'000;
                expect_as_the_reference(made.request);
            }
        }
    }
}

// A million draws of one radius: comparing all pairs would take longer than a test may.
TEST_P(Crowd, OfAMillionEnds) {
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        Request request = crowded(mode, 0.5, 1'000'000, Boundary::box);
        request.place.backend = GetParam();
        const Result result = sample(request);
        EXPECT_TRUE(result.maximal);
        EXPECT_GE(result.points.size(), 2u);
        EXPECT_LE(result.points.size(), 7u);
    }
}

INSTANTIATE_TEST_SUITE_P(Backend, Crowd, tests::kParallelBackends, tests::name_of_parameter);

}  // namespace

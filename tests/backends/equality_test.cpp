// Every backend gives the reference's samples, number for number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/radius_field_requests.h"
#include "backends/requests.h"
#include "plan/checked_request.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

class Equality : public tests::OnBackend {};

// Names the first draw that differs, its line and both values.
testing::AssertionResult same(const Request& request, const Plan& plan, const Outcome& expected,
                              const Outcome& got) {
    const std::size_t common = std::min(expected.samples.size(), got.samples.size());
    for (std::size_t i = 0; i < common; ++i) {
        const Sample a = expected.samples[i];
        const Sample b = got.samples[i];
        if (a == b) continue;
        return testing::AssertionFailure()
               << tests::describe(request) << "\nsample " << i << ", draw " << expected.numbers[i]
               << ", line " << plan.line_of(a) << ": expected (" << a.x << ", " << a.y << "), got ("
               << b.x << ", " << b.y << ") on line " << plan.line_of(b);
    }
    if (expected.samples.size() != got.samples.size())
        return testing::AssertionFailure()
               << tests::describe(request) << "\nthe first " << common << " samples agree, but of "
               << expected.samples.size() << " expected there are " << got.samples.size();
    if (expected.rounds != got.rounds || expected.draws != got.draws)
        return testing::AssertionFailure()
               << tests::describe(request) << "\nrounds or draws differ";
    return testing::AssertionSuccess();
}

Outcome run(Request request, const Plan& plan, const std::string& backend) {
    Observer nobody;
    request.run_on.backend = backend;
    return run_on_backend(request, plan, nobody).outcome;
}

// The reference's outcome for request `number` of a group. It is made once in a process, because
// ctest runs a test for all backends in one process.
const Outcome& reference_outcome(const std::string& group, std::size_t number,
                                 const Request& request, const Plan& plan) {
    static std::map<std::pair<std::string, std::size_t>, Outcome> known;
    const auto [found, is_new] = known.try_emplace({group, number});
    if (is_new) found->second = run(request, plan, "reference");
    return found->second;
}

void expect_equal(const std::string& group, std::size_t number, const Request& request,
                  const std::string& backend) {
    const Plan plan = make_plan(request);
    const Outcome& expected = reference_outcome(group, number, request, plan);
    ASSERT_EQ(expected.samples.empty(), !has_places(request));
    ASSERT_TRUE(same(request, plan, expected, run(request, plan, backend)));
}

template <class Made>
void expect_equal_on(const std::string& group, const std::vector<Made>& requests,
                     const std::string& backend) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
        SCOPED_TRACE(requests[i].name);
        expect_equal(group, i, requests[i].request, backend);
    }
}

void expect_equal_on(const std::string& group, const std::vector<Request>& requests,
                     const std::string& backend) {
    for (std::size_t i = 0; i < requests.size(); ++i) expect_equal(group, i, requests[i], backend);
}

TEST_P(Equality, OnEveryKindOfRequestInCells) {
    const std::vector<tests::CellsRequest> requests = tests::cells_requests();
    ASSERT_GE(requests.size(), 60u);
    expect_equal_on("cells", requests, GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestWithARadiusField) {
    const std::vector<tests::FieldRequest> requests = tests::radius_field_requests();
    ASSERT_GE(requests.size(), 60u);
    expect_equal_on("radius field", requests, GetParam());
}

TEST_P(Equality, OnRequestsThatLeaveNoPlace) {
    expect_equal_on("without places", tests::requests_without_places(), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestWithClasses) {
    expect_equal_on("classes", tests::class_requests(), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestWithEllipses) {
    expect_equal_on("ellipses", tests::ellipse_requests(), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestInLines) {
    expect_equal_on("lines", tests::equality_requests(Mode::lines), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestInExact) {
    expect_equal_on("exact", tests::equality_requests(Mode::exact), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestInCrowdedRounds) {
    expect_equal_on("crowds", tests::crowded_requests(), GetParam());
    expect_equal_on("crowds in cells", tests::crowded_cells_requests(), GetParam());
}

// A million draws of one radius: comparing all pairs would take longer than a test may.
TEST_P(Equality, OfARoundOfAMillionDrawsEnds) {
    for (const Mode mode : {Mode::exact, Mode::lines}) {
        Request request;
        request.mode = mode;
        request.radius = 0.5;
        request.paper2011.round_size = 1'000'000;
        request.run_on.backend = GetParam();
        const Result result = sample(request);
        EXPECT_TRUE(result.maximal);
        EXPECT_GE(result.points.size(), 2u);
        EXPECT_LE(result.points.size(), 7u);
    }
}

// Returns the count.
double expect_equal_on_a_large_set(const Request& request, const std::string& backend) {
    const Plan plan = make_plan(request);
    const Outcome got = run(request, plan, backend);
    EXPECT_LE(got.rounds, 60u);
    EXPECT_TRUE(same(
        request, plan,
        reference_outcome("large", static_cast<std::size_t>(request.mode), request, plan), got));
    return static_cast<double>(got.samples.size());
}

Request large_request(Mode mode, double radius) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    return request;
}

TEST_P(Equality, OnALargeSetInLines) {
    // docs/design.md, section 5: 0.3 to 0.4 % fewer than the true maximum.
    constexpr double kRadius = 0.0016;
    EXPECT_NEAR(expect_equal_on_a_large_set(large_request(Mode::lines, kRadius), GetParam()) *
                    kRadius * kRadius,
                0.6919, 0.0015);
}

TEST_P(Equality, OnALargeSetInExact) {
    // docs/design.md, section 5, and five standard deviations of a set of this size.
    EXPECT_NEAR(expect_equal_on_a_large_set(large_request(Mode::exact, 0.0016), GetParam()),
                272'094, 638);
}

TEST_P(Equality, OnALargeSetInCells) {
    // docs/design.md, section 5: within 2 %; and the lattice's loss (docs/cells.md).
    const tests::CellsRequest made = tests::large_cells_request();
    EXPECT_NEAR(expect_equal_on_a_large_set(made.request, GetParam()), 49'000, 1'500);
}

TEST_P(Equality, IsTheOneThatRan) {
    Request request;
    request.radius = 0.1;
    request.run_on.backend = GetParam();
    EXPECT_EQ(sample(request).backend, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Backend, Equality, tests::kParallelBackends, tests::name_of_parameter);

TEST(Backends, WithoutDevicesRefuseTheNameOfOne) {
    Request request;
    request.radius = 0.1;
    request.run_on.device = "GeForce";
    for (const char* const backend : {"cpu", "reference", "auto"}) {
        request.run_on.backend = backend;
        EXPECT_THROW(sample(request), BadRequest) << backend;
    }
}

}  // namespace

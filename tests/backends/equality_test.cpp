// Every backend gives the reference's samples, number for number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/radius_field_requests.h"
#include "backends/requests.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "refusal.h"
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
    request.backend = backend;
    return run_on_backend(request, plan, nobody).outcome;
}

// The reference's outcome for request `number` of a mode. It is made once in a process, because
// ctest runs a test for all backends in one process.
const Outcome& reference_outcome(std::size_t number, const Request& request, const Plan& plan) {
    static std::map<std::pair<Mode, std::size_t>, Outcome> known;
    const auto [found, is_new] = known.try_emplace({request.mode, number});
    if (is_new) found->second = run(request, plan, "reference");
    return found->second;
}

void expect_equal_on_every_kind_of_request(Mode mode, const std::string& backend) {
    const std::vector<Request> requests = tests::equality_requests(mode);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const Plan plan = make_plan(requests[i]);
        ASSERT_TRUE(same(requests[i], plan, reference_outcome(i, requests[i], plan),
                         run(requests[i], plan, backend)));
    }
}

TEST_P(Equality, OnEveryKindOfRequestInCells) {
    const std::vector<tests::CellsRequest> requests = tests::cells_requests();
    ASSERT_GE(requests.size(), 60u);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const tests::CellsRequest& made = requests[i];
        SCOPED_TRACE(made.name);
        const Plan plan = make_plan(made.request);
        const Outcome& expected = reference_outcome(i, made.request, plan);
        ASSERT_FALSE(expected.samples.empty());
        ASSERT_TRUE(same(made.request, plan, expected, run(made.request, plan, GetParam())));
    }
}

void expect_equal_on(const std::vector<tests::FieldRequest>& requests, const std::string& backend) {
    for (const tests::FieldRequest& made : requests) {
        SCOPED_TRACE(made.name);
        const Plan plan = make_plan(made.request);
        const Outcome expected = run(made.request, plan, "reference");
        ASSERT_FALSE(expected.samples.empty());
        ASSERT_TRUE(same(made.request, plan, expected, run(made.request, plan, backend)));
    }
}

TEST_P(Equality, OnEveryKindOfRequestWithARadiusField) {
    const std::vector<tests::FieldRequest> requests = tests::radius_field_requests();
    ASSERT_GE(requests.size(), 60u);
    expect_equal_on(requests, GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestWithClasses) {
    expect_equal_on(tests::class_requests(), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestWithEllipses) {
    expect_equal_on(tests::ellipse_requests(), GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestInLines) {
    expect_equal_on_every_kind_of_request(Mode::lines, GetParam());
}

TEST_P(Equality, OnEveryKindOfRequestInExact) {
    expect_equal_on_every_kind_of_request(Mode::exact, GetParam());
}

// Returns the count.
double expect_equal_on_a_large_set(const Request& request, const std::string& backend) {
    const Plan plan = make_plan(request);
    const Outcome got = run(request, plan, backend);
    EXPECT_LE(got.rounds, 60u);
    constexpr std::size_t kLarge = std::numeric_limits<std::size_t>::max();
    EXPECT_TRUE(same(request, plan, reference_outcome(kLarge, request, plan), got));
    return static_cast<double>(got.samples.size());
}

Request large_request(Mode mode, double radius) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.boundary = Boundary::torus;
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
    // docs/design.md, section 5, and five standard deviations.
    EXPECT_NEAR(expect_equal_on_a_large_set(large_request(Mode::exact, 0.001), GetParam()), 696'560,
                1'020);
}

TEST_P(Equality, OnALargeSetInCells) {
    // docs/design.md, section 5: within 2 %; and the lattice's loss (docs/cells.md).
    const tests::CellsRequest made = tests::large_cells_request();
    EXPECT_NEAR(expect_equal_on_a_large_set(made.request, GetParam()), 49'000, 1'500);
}

TEST_P(Equality, IsTheOneThatRan) {
    Request request;
    request.radius = 0.1;
    request.backend = GetParam();
    EXPECT_EQ(sample(request).backend, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Backend, Equality, tests::kParallelBackends, tests::name_of_parameter);

TEST(Backends, UnknownNameIsRefusedWithTheKnownOnes) {
    Request request;
    request.radius = 0.1;
    request.backend = "gpu";
    const std::string what = tests::refusal_of([&] { sample(request); });
    EXPECT_TRUE(what.starts_with("backend gpu: must be one of auto, cpu, ")) << what;
}

TEST(Backends, WithoutDevicesRefuseTheNameOfOne) {
    Request request;
    request.radius = 0.1;
    request.device = "GeForce";
    for (const char* const backend : {"cpu", "reference", "auto"}) {
        request.backend = backend;
        EXPECT_THROW(sample(request), BadRequest) << backend;
    }
}

TEST(Backends, TheEnvironmentChoosesWhenTheRequestDoesNot) {
    Request request;
    request.radius = 0.1;
    setenv("LACUNA_BACKEND", "reference", 1);
    EXPECT_EQ(sample(request).backend, "reference");
    request.backend = "cpu";
    EXPECT_EQ(sample(request).backend, "cpu");
    unsetenv("LACUNA_BACKEND");
    request.backend = "auto";
    EXPECT_EQ(sample(request).backend, "cpu");
}

}  // namespace

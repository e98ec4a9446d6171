// Any number of ranks makes the set of one process, whole number for whole number.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/backends.h"
#include "backends/requests.h"
#include "plan/plan.h"
#include "ranks/run_on_ranks.h"

namespace {

using namespace lacuna;

class OnRanks : public tests::OnBackend {};

void expect_same(const Request& request, std::uint32_t ranks, const std::string& backend,
                 std::uint32_t depth = Border::kDepth) {
    SCOPED_TRACE(tests::describe(request) + ", ranks " + std::to_string(ranks));
    const Plan plan = make_plan(request);
    Observer nobody;
    Request alone = request;
    alone.backend = "cpu";
    const Outcome expected = run_on_backend(alone, plan, nobody).outcome;

    const tests::MadeOnRanks made = tests::run_on_ranks(plan, ranks, backend, depth);

    EXPECT_EQ(made.outcome.rounds, expected.rounds);
    EXPECT_EQ(made.outcome.draws, expected.draws);
    EXPECT_EQ(made.outcome.samples, expected.samples.size());
    ASSERT_TRUE(made.samples == expected.samples);
}

TEST_P(OnRanks, SameSetOnEveryKindOfRequest) {
    for (const Request& request : tests::equality_requests(Mode::exact)) {
        const std::uint32_t most = most_ranks(make_plan(request));
        for (const std::uint32_t ranks : {1u, 2u, 3u, 5u})
            if (ranks <= most) expect_same(request, ranks, GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Backend, OnRanks, tests::kParallelBackends, tests::name_of_parameter);

}  // namespace

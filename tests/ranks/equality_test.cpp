// Any number of ranks makes the set of one process, number for number.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/requests.h"
#include "plan/make_plan.h"
#include "ranks/run_on_ranks.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

Outcome made_alone(const Request& request) {
    Observer nobody;
    Request alone = request;
    alone.run_on.backend = "cpu";
    return run_on_backend(alone, make_plan(request), nobody).outcome;
}

tests::MadeOnRanks expect_same(const Request& request, const Outcome& expected, std::uint32_t ranks,
                               const std::vector<std::string>& backends,
                               std::uint32_t depth = Border::kDepth) {
    SCOPED_TRACE(tests::describe(request) + ", ranks " + std::to_string(ranks));
    tests::MadeOnRanks made = tests::run_on_ranks(make_plan(request), ranks, backends, depth);
    EXPECT_EQ(made.outcome.rounds, expected.rounds);
    EXPECT_EQ(made.outcome.draws, expected.draws);
    EXPECT_EQ(made.outcome.samples, expected.samples.size());
    EXPECT_TRUE(made.samples == expected.samples);
    return made;
}

// The number of rounds, over all ranks, in which a rank had to locate all columns (whole looks).
std::uint64_t whole_looks(const tests::MadeOnRanks& made) {
    std::uint64_t looks = 0;
    for (const Border::Tally& tally : made.tallies) looks += tally.whole_looks;
    return looks;
}

Request small_request(double width, double height, double radius, Boundary boundary) {
    Request request;
    request.domain.width = width;
    request.domain.height = height;
    request.radius = radius;
    request.domain.boundary = boundary;
    request.seed = 20;
    return request;
}

class OnRanks : public tests::OnBackend {};

TEST_P(OnRanks, TheSetOfOneProcess) {
    const std::vector<Request> requests = tests::equality_requests(Mode::exact);
    const bool is_cpu = GetParam() == "cpu";
    std::size_t compared = 0;
    // Device backends are slow to make: a few requests of every kind.
    for (std::size_t i = 0; i < requests.size(); i += is_cpu ? 1 : 23) {
        const Outcome expected = made_alone(requests[i]);
        const std::uint32_t most = most_ranks(make_plan(requests[i]));
        for (const std::uint32_t ranks : {1u, 2u, 3u, 5u}) {
            if (ranks > most || (!is_cpu && ranks % 2 != 0 && ranks != 3)) continue;
            expect_same(requests[i], expected, ranks, {GetParam()});
            ++compared;
        }
    }
    EXPECT_GE(compared, is_cpu ? 600u : 12u);
}

TEST_P(OnRanks, TheFirstSamplesOfALimit) {
    for (const std::uint64_t limit : {1u, 2u, 700u, 5000u}) {
        Request request = small_request(2, 1, 0.02, Boundary::torus);
        request.limit = limit;
        expect_same(request, made_alone(request), 3, {GetParam()});
    }
}

INSTANTIATE_TEST_SUITE_P(Backend, OnRanks, tests::kParallelBackends, tests::name_of_parameter);

// Ranks may run on different machines: some on a card, some on processors.
class OnUnlikeRanks : public tests::OnBackend {};

TEST_P(OnUnlikeRanks, TheSetOfOneProcess) {
    std::vector<std::string> backends{"cpu", GetParam()};
    for (const std::string other : {"opencl", "vulkan"})
        if (other != GetParam() && tests::why_missing(other).empty()) backends.push_back(other);
    const std::vector<Request> requests = tests::equality_requests(Mode::exact);
    std::size_t compared = 0;
    for (std::size_t i = 7; i < requests.size(); i += 41) {
        if (most_ranks(make_plan(requests[i])) < 4) continue;
        expect_same(requests[i], made_alone(requests[i]), 4, backends);
        ++compared;
    }
    EXPECT_GE(compared, 3u);
}

INSTANTIATE_TEST_SUITE_P(Device, OnUnlikeRanks, tests::kDeviceBackends, tests::name_of_parameter);

TEST(ManyRanks, FromOneTo64) {
    for (const Boundary boundary : {Boundary::torus, Boundary::box}) {
        const Request request = small_request(8, 1, 0.05, boundary);
        const Outcome expected = made_alone(request);
        const std::uint32_t most = most_ranks(make_plan(request));
        ASSERT_GE(most, 64u);
        for (std::uint32_t ranks = 1; ranks <= 64; ranks += ranks < 8 ? 1 : 14)
            expect_same(request, expected, ranks, {"cpu"});
        expect_same(request, expected, 64, {"cpu"});
    }
}

// On a torus as narrow as two strips each rank is the other's neighbour on both sides.
TEST(FewColumns, AsManyRanksAsThereMayBe) {
    for (const double radius : {0.45, 0.2, 0.15, 0.11})
        for (const double height : {1.0, 0.5, 40.0}) {
            const Request request = small_request(1, height, radius, Boundary::torus);
            const std::uint32_t most = most_ranks(make_plan(request));
            for (std::uint32_t ranks = 1; ranks <= most; ++ranks)
                expect_same(request, made_alone(request), ranks, {"cpu"});
        }
}

TEST(Border, LooksAtTheWholeStripWhereItMust) {
    Request request = small_request(4, 1, 0.01, Boundary::torus);
    const Outcome expected = made_alone(request);

    const tests::MadeOnRanks made = expect_same(request, expected, 4, {"cpu"}, 2);

    EXPECT_GT(whole_looks(made), 0u);
    // At the usual depth of Border, no rank has to locate all columns.
    EXPECT_EQ(whole_looks(expect_same(request, expected, 4, {"cpu"})), 0u);
}

TEST(Border, SettlesRoundsThatCrowd) {
    Request request = small_request(3, 1, 0.05, Boundary::torus);
    for (const std::uint64_t size : {1000u, 30000u}) {
        request.paper2011.round_size = size;
        const Outcome expected = made_alone(request);
        for (const std::uint32_t ranks : {2u, 7u}) expect_same(request, expected, ranks, {"cpu"});
    }
}

TEST(Border, SendsFewBytesASampleAndMessagesThatDoNotGrowWithTheSet) {
    std::vector<double> messages_a_round;
    for (const double radius : {0.02, 0.005, 0.00125}) {
        const Request request = small_request(1, 1, radius, Boundary::torus);
        const Outcome expected = made_alone(request);
        const tests::MadeOnRanks made = expect_same(request, expected, 4, {"cpu"});
        std::uint64_t samples = 0;
        for (const Border::Tally& tally : made.tallies) {
            samples += tally.samples;
            messages_a_round.push_back(static_cast<double>(tally.messages) /
                                       static_cast<double>(expected.rounds));
        }
        EXPECT_GT(samples, 0u);
        EXPECT_LE(made.bytes, 64 * samples) << "radius " << radius;
    }
    // Messages to two neighbours: the candidates, then some two or three passes.
    for (const double messages : messages_a_round) EXPECT_LE(messages, 8);
}

}  // namespace

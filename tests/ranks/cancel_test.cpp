// If one rank is cancelled, all ranks stop.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <vector>

#include "backends/cpu/cpu_backend.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "ranks/run_on_ranks.h"

namespace {

using namespace lacuna;

class StopsAfter : public Observer {
public:
    explicit StopsAfter(std::uint64_t rounds) : rounds_(rounds) {}
    bool keep_going(const Progress& progress) override { return progress.rounds < rounds_; }

private:
    std::uint64_t rounds_;
};

TEST(Cancelled, OnAllRanksWhereOneIsToldToStop) {
    Request request;
    request.radius = 0.02;
    request.domain.boundary = Boundary::torus;
    const Plan plan = make_plan(request);
    tests::Ring ring(3);
    tests::SharedSink shared;
    std::atomic<int> cancelled = 0;
    tests::on_threads(ring, [&](Ranks& ranks) {
        const Strip strip = strip_of(plan, ranks.rank(), ranks.count());
        const auto backend = cpu::make_backend(strip.plan, {});
        tests::RankSink sink(shared);
        StopsAfter observer(ranks.rank() == 1 ? 3 : 1000);
        try {
            generate_on_ranks(plan, strip, *backend, ranks, sink, observer);
        } catch (const Cancelled&) {
            ++cancelled;
        }
    });
    EXPECT_EQ(cancelled, 3);
}

}  // namespace

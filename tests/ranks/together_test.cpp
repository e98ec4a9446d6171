// If one rank cannot do something, no rank goes on.
#include <gtest/gtest.h>

#include <atomic>
#include <exception>
#include <stdexcept>

#include "ranks/thread_ranks.h"
#include "ranks/together.h"

namespace {

using namespace lacuna;

TEST(Together, AllRanksFailWhereOneDoes) {
    tests::Ring ring(5);
    std::atomic<int> failed = 0;
    std::atomic<int> had_reason = 0;
    tests::on_threads(ring, [&](Ranks& ranks) {
        try {
            together(ranks, [&] {
                if (ranks.rank() == 3) throw std::runtime_error("no disk");
            });
        } catch (const FailedTogether& together_) {
            ++failed;
            if (together_.own) ++had_reason;
        }
    });
    EXPECT_EQ(failed, 5);
    EXPECT_EQ(had_reason, 1);
}

TEST(Together, NoneFailsWhereNoneDoes) {
    tests::Ring ring(3);
    std::atomic<int> done = 0;
    tests::on_threads(ring, [&](Ranks& ranks) {
        together(ranks, [] {});
        ++done;
    });
    EXPECT_EQ(done, 3);
}

}  // namespace

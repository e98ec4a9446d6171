// Rounds so large that launches are sliced: the same samples and boxes, and cancelled in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "backends/available.h"
#include "backends/opencl/make_backend.h"
#include "backends/scenes.h"

namespace lacuna::opencl {
namespace {

// Enough for three slices a launch at least.
constexpr std::uint32_t kDraws = 400'000;

class Slices : public testing::Test {
protected:
    void SetUp() override {
        tests::skip_or_fail_without("opencl");
        tests::Chance chance(31);
        draws_ = tests::random_draws(plan_, tests::empty_memory(plan_), chance, kDraws);
    }

    const Plan plan_ = tests::plan_of(0.001, 2, Boundary::torus, 1, 1, Mode::exact);
    std::vector<Draw> draws_;
};

struct Left {
    std::vector<Sample> samples;
    std::vector<Box> boxes;
};

Left after_two_rounds(Backend& backend, const std::vector<Draw>& draws) {
    backend.locate(draws);
    backend.admit();
    backend.subtract();
    const Round round = backend.finish_round();
    Left left{{round.samples.begin(), round.samples.end()}, {}};
    backend.locate({});
    backend.admit();
    backend.refine(true);
    left.boxes = backend.snapshot().boxes;
    return left;
}

TEST_F(Slices, LeaveWhatTheCpuLeaves) {
    std::uint64_t launches = 0;
    const auto backend = make_backend(plan_, {}, {}, {"", &launches});
    const Left expected = after_two_rounds(*tests::make_backend("cpu", plan_), draws_);
    const Left got = after_two_rounds(*backend, draws_);
    EXPECT_GT(expected.boxes.size(), 100'000u);
    EXPECT_TRUE(expected.samples == got.samples);
    EXPECT_TRUE(expected.boxes == got.boxes);
    // A round of one slice a launch takes 14, a refinement 21, and the start a few.
    EXPECT_GT(launches, 14u * 2 + 21 + 10);
}

TEST_F(Slices, CanBeCancelledInBetween) {
    int asked = 0;
    const auto backend = make_backend(plan_, {}, {}, {});
    backend->watch([&] { return ++asked > 0; });
    backend->locate(draws_);
    const int asked_by_locate = asked;
    EXPECT_GT(asked_by_locate, 2);

    for (int allowed = 0; allowed < asked_by_locate; ++allowed) {
        asked = 0;
        backend->watch([&] { return ++asked <= allowed; });
        EXPECT_THROW(backend->locate(draws_), Cancelled) << allowed;
        EXPECT_EQ(asked, allowed + 1);
    }
}

}  // namespace
}  // namespace lacuna::opencl

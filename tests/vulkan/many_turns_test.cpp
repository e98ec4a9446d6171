// What becomes of loops that a driver ends before their time: an error, never a wrong set.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "plan.h"
#include "portable/fate.h"
#include "vulkan/make_backend.h"

namespace {

using namespace lacuna;

// Lavapipe ends an invocation's loops after 65,535 turns. Drivers that do not must give the right
// answer.
class ManyTurns : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("vulkan"); }

    static constexpr std::uint32_t kTurns = 70'000;

    // One line, whose free spans are so many that one loop over them is too long.
    ManyTurns() {
        scene_.capacity = kTurns + 8;
        scene_.spans.resize(plan_.lines);
        for (std::uint32_t i = 0; i < kTurns; ++i) scene_.spans[0].push_back({4 * i, 4 * i + 1});
        scene_.cells.assign(std::size_t{plan_.cell_columns} * plan_.cell_rows,
                            {NO_SAMPLE, NO_SAMPLE});
    }
    static Plan make() {
        Request request;
        request.radius = 0.9;
        request.boundary = Boundary::torus;
        request.lines_per_radius = 1;
        return make_plan(request);
    }

    // What the verb leaves, or what it says of the verb that went wrong.
    template <typename Verb>
    void expect_right_or_failed(const std::string& name, Verb verb) {
        const auto expected = cpu::make_backend(plan_, {});
        const auto got = vulkan::make_backend(plan_, {});
        for (Backend* const each : {expected.get(), got.get()}) each->restore(scene_);
        verb(*expected);
        const bool is_limited = got->device().find("llvmpipe") != std::string::npos;
        try {
            verb(*got);
            got->finish_round();
            EXPECT_FALSE(is_limited) << "nothing was thrown";
            EXPECT_EQ(got->snapshot(), expected->snapshot());
        } catch (const DeviceError& error) {
            const std::string what = error.what();
            EXPECT_NE(what.find(name + ": a loop was ended early by the driver: use fewer points"),
                      std::string::npos)
                << what;
            EXPECT_NE(what.find(got->device()), std::string::npos) << what;
        }
    }

    const Plan plan_ = make();
    Snapshot scene_;
};

TEST_F(ManyTurns, AreAnErrorOfLocateOrLocatedAsByTheCpu) {
    const std::vector<Draw> draws = {{0, kTurns - 1, 0, 0}};
    expect_right_or_failed("locate", [&](Backend& backend) { backend.locate(draws); });
}

TEST_F(ManyTurns, AreAnErrorOfLocateOrSortedAsByTheCpu) {
    scene_.spans[0] = {{0, kTurns}};
    std::vector<Draw> draws;
    for (std::uint32_t i = 0; i < kTurns; ++i) draws.push_back({0, i, 0, kTurns - 1 - i});
    expect_right_or_failed("locate", [&](Backend& backend) { backend.locate(draws); });
}

TEST_F(ManyTurns, AreAnErrorOfSubtractOrSubtractedAsByTheCpu) {
    scene_.candidates = {{plan_.centre_of_line(0), plan_.height / 2, 0, 0}};
    scene_.fates = {FATE_ADMITTED};
    expect_right_or_failed("subtract", [](Backend& backend) { backend.subtract(); });
}

TEST_F(ManyTurns, AreAnErrorOfRefineOrRefinedAsByTheCpu) {
    expect_right_or_failed("refine", [](Backend& backend) { backend.refine(true); });
}

}  // namespace

// If a driver ends a loop too early, the result is an error, never a wrong set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/columns.h"
#include "backends/vulkan/vulkan_backend.h"
#include "fields.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "portable/status.h"

namespace {

using namespace lacuna;

// Some drivers end an invocation's loops after 65,535 turns, among them lavapipe of Mesa 22. Others
// have no such limit, like lavapipe of Mesa 25: they must give the right answer.
class ManyTurns : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("vulkan"); }

    static constexpr std::uint32_t kTurns = 70'000;

    explicit ManyTurns(Plan plan) : plan_(std::move(plan)) {}

    // Expects the memory that the cpu backend leaves, or a DeviceError that names the verb.
    template <typename Verb>
    void expect_right_or_failed(const std::string& name, Verb verb) {
        const auto expected = cpu::make_backend(plan_, {});
        const auto got = vulkan::make_backend(plan_, {});
        for (Backend* const each : {expected.get(), got.get()}) each->restore(scene_);
        verb(*expected);
        try {
            verb(*got);
            got->finish_round();
            const Snapshot right = expected->snapshot();
            Snapshot left = got->snapshot();
            left.capacity = right.capacity;  // each backend's own choice
            EXPECT_TRUE(left == right) << "nothing was thrown, and the outcome is wrong";
        } catch (const DeviceError& error) {
            const std::string what = error.what();
            EXPECT_NE(what.find(name + ": a loop was ended early by the driver"), std::string::npos)
                << what;
            EXPECT_NE(what.find("use another backend"), std::string::npos) << what;
            EXPECT_NE(what.find(got->device()), std::string::npos) << what;
        }
    }

    // Draws of one column, far more than a loop may take turns.
    void expect_located_right(const std::vector<Draw>& draws) {
        const auto expected = cpu::make_backend(plan_, {});
        const auto got = vulkan::make_backend(plan_, {});
        for (Backend* const each : {expected.get(), got.get()}) {
            each->restore(scene_);
            each->locate(draws);
        }
        const Snapshot left = got->snapshot();
        const Snapshot right = expected->snapshot();
        EXPECT_TRUE(left.candidates == right.candidates);
        EXPECT_TRUE(left.statuses == right.statuses);
        EXPECT_TRUE(left.spans == right.spans);
        EXPECT_TRUE(left.bits == right.bits);
    }

    const Plan plan_;
    Snapshot scene_;
};

// One line, whose free spans are so many that one loop over them is too long.
class ManySpans : public ManyTurns {
protected:
    ManySpans() : ManyTurns(make()) {
        scene_.capacity = kTurns + 8;
        scene_.spans.resize(plan_.lines);
        for (std::uint32_t i = 0; i < kTurns; ++i) scene_.spans[0].push_back({4 * i, 4 * i + 1});
        scene_.grid.assign(std::size_t{plan_.grid().columns} * plan_.grid().rows,
                           {NO_SAMPLE, NO_SAMPLE});
    }
    static Plan make() {
        Request request;
        request.radius = 0.9;
        request.domain.boundary = Boundary::torus;
        request.paper2011.lines_per_radius = 1;
        return make_plan(request);
    }
};

TEST_F(ManySpans, AreAnErrorOfLocateOrLocatedAsByTheCpu) {
    const std::vector<Draw> draws = {{0, kTurns - 1, 0, 0}};
    expect_right_or_failed("locate", [&](Backend& backend) { backend.locate(draws); });
}

TEST_F(ManySpans, OrOneWithManyDrawsAreSortedAsByTheCpu) {
    scene_.spans[0] = {{0, kTurns}};
    std::vector<Draw> draws;
    for (std::uint32_t i = 0; i < kTurns; ++i) draws.push_back({0, i, 0, kTurns - 1 - i});
    expect_located_right(draws);
}

TEST_F(ManySpans, AreAnErrorOfSubtractOrSubtractedAsByTheCpu) {
    scene_.candidates = {{plan_.centre_of_line(0), plan_.height / 2, 0, 0}};
    scene_.statuses = {STATUS_ADMITTED};
    expect_right_or_failed("subtract", [](Backend& backend) { backend.subtract(); });
}

TEST_F(ManySpans, AreAnErrorOfRefineOrRefinedAsByTheCpu) {
    expect_right_or_failed("refine", [](Backend& backend) { backend.refine(true); });
}

// A high lattice of one column, as high as the field, and one pixel whose radius spans half of it.
class ManyPixels : public ManyTurns {
protected:
    static constexpr std::uint32_t kRows = 40'000;

    ManyPixels() : ManyTurns(make()) { scene_ = tests::empty_memory(plan_); }
    static Plan make() {
        Field field = tests::noise_field(1, kRows, 5);
        for (double& importance : field.importance) importance = std::max(importance, 0.5);
        field.importance[kRows / 2] = 1.0 / kRows;
        return tests::cells_plan(field, 2.5, 100, Metric::min, Boundary::box, 1, 1000);
    }
};

TEST_F(ManyPixels, AreSortedAsByTheCpu) {
    ASSERT_EQ(count_columns(plan_), 1u);
    std::vector<Draw> draws;
    for (std::uint32_t i = 0; i < kTurns; ++i) draws.push_back({0, i / 2, 0, kTurns - 1 - i});
    expect_located_right(draws);
}

TEST_F(ManyPixels, AreAnErrorOfSubtractOrSubtractedAsByTheCpu) {
    const std::uint32_t y = plan_.height / 2 - 1;
    ASSERT_GT(plan_.cells().radii->reaches[plan_.cells().radii->pixel_at(0, y)], plan_.height / 3);
    scene_.candidates = {{0, y, 0, 0}};
    scene_.statuses = {STATUS_ADMITTED};
    expect_right_or_failed("subtract", [](Backend& backend) { backend.subtract(); });
}

// A box that many kept samples of two classes cut into pieces; items that serve such boxes together
// took more turns than lavapipe grants.
TEST(ManyPieces, AreKeptAsByTheCpu) {
    tests::skip_or_fail_without("vulkan");
    Request request;
    request.classes.names = {"wide", "narrow"};
    request.classes.distances = distances_by_union(std::vector{0.019, 0.014});
    request.seed = 1;
    request.progressive = true;
    request.limit = 1533;
    request.run_on.backend = "cpu";
    const Result kept = sample(request);
    request.progressive = false;
    request.limit.reset();
    request.keep = kept.points;
    request.keep_classes = kept.classes;
    request.radius = kept.levels.back().size * std::exp2(-1.0 / 16);
    const Result expected = sample(request);
    request.run_on.backend = "vulkan";
    EXPECT_EQ(sample(request).points, expected.points);
}

}  // namespace

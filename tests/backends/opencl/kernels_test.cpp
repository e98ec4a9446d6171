// The kernels do the work, and nothing else does: launches are counted, and wrong kernels noticed.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/opencl/make_backend.h"
#include "backends/opencl/trials.h"
#include "backends/scenes.h"

namespace lacuna::opencl {
namespace {

// The same of modes lines and exact.
std::string altered(const std::string& from, const std::string& to) {
    return opencl::altered(kernel_source(), from, to);
}

class Kernels : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("opencl"); }

    const Plan plan_ = tests::plan_of(0.03, 6, Boundary::torus);
    const Plan exact_ = tests::plan_of(0.03, 6, Boundary::torus, 1, 1, Mode::exact);
};

TEST_F(Kernels, AreLaunchedAFewTimesARoundNeverOnceASample) {
    std::uint64_t launches = 0;
    const Outcome outcome = run(plan_, kernel_source(), &launches);
    EXPECT_TRUE(outcome.samples == on_cpu(plan_));
    // locate, sort_columns, eight passes, gather, subtract; and what is left of the start.
    EXPECT_GE(launches, 12 * outcome.rounds);
    EXPECT_LE(launches, 16 * outcome.rounds + 10);
}

TEST_F(Kernels, AreLaunchedAFewTimesARoundInExactToo) {
    std::uint64_t launches = 0;
    const Outcome outcome = run(exact_, kernel_source(), &launches);
    EXPECT_TRUE(outcome.samples == on_cpu(exact_));
    // screen and insert besides; then, in place of gather and subtract, cut, scan twice, keep and
    // find_place_begins.
    EXPECT_GE(launches, 14 * outcome.rounds);
    EXPECT_LE(launches, 17 * outcome.rounds + 10);
}

TEST_F(Kernels, ThatAreWrongAreNoticed) {
    const std::vector<Sample> right = on_cpu(plan_);
    const std::pair<const char*, const char*> faults[] = {
        {"span.x + (draw.y - passed), line", "span.x + (draw.y - passed) / 2u, line"},
        {"if (other.w >= candidate.w) continue;", "if (other.w <= candidate.w) continue;"},
        {"return waits ? FATE_UNDECIDED", "return false ? FATE_UNDECIDED"},
        {"to > begin && comes_before(", "false && comes_before("},
        {"window < windows", "window < 1u"},
        {"if (bottom > 0u) fits", "if (false) fits"},
        {"if (top < g.height && fits)", "if (false)"},
        {"y - reach + 1u : 0u", "y - reach + 1000u : 0u"},
    };
    for (const auto& [from, to] : faults)
        EXPECT_TRUE(run(plan_, altered(from, to)).samples != right) << from << " became " << to;
}

TEST_F(Kernels, ThatAreWrongInExactAreNoticed) {
    // The last few take many refinements, of more and more boxes where a kernel leaves room.
    Plan nearly_all = exact_;
    nearly_all.limit = nearly_all.expected_samples * 19 / 20;
    const std::vector<Sample> right = on_cpu(nearly_all);
    const std::pair<const char*, const char*> faults[] = {
        {"box_begin[draw.x] + draw.y,", "box_begin[draw.x] + draw.y / 2u,"},
        {"? candidate.x\n", "? candidate.x / g.strip_width * g.strip_width\n"},
        {"return covered;", "return false;"},
        {"i < x_windows", "i < 1u"},
        {"g.period_x) + g.chord_margin", "g.period_x)"},
        {"grid_y[cell] = sample.y", "grid_y[cell] = sample.x"},
        {"if (column_low > column_high) continue;", "if (i > 0u) continue;"},
        {"if (bottom > begin) add_chord", "if (false) add_chord"},
        {"if (top < end) add_chord", "if (false) add_chord"},
        {"last > y ? last - y : 0u", "0u"},
        {"= piece.end - piece.begin;", "= 1u;"},
        {"box_x[middle] / g.strip_width < line", "box_x[middle] / g.strip_width < line / 2u"},
    };
    for (const auto& [from, to] : faults)
        EXPECT_TRUE(run(nearly_all, altered(from, to)).samples != right)
            << from << " became " << to;
}

// What a driver that ends loops early would leave behind, by kernel.
TEST_F(Kernels, WhoseLoopsAreEndedEarlyAreAnErrorAndNeverASet) {
    const std::pair<const char*, const char*> jobs[] = {
        {"FAILED_LOCATE", "locate"}, {"FAILED_SORT_COLUMNS", "sort_columns"},
        {"FAILED_ADMIT", "admit"},   {"FAILED_GATHER", "gather"},
        {"FAILED_REFINE", "refine"}, {"FAILED_SUBTRACT", "subtract"},
    };
    for (const auto& [flag, job] : jobs) {
        const std::string raises = "atomic_or(failure, " + std::string(flag) + ");";
        const std::string check = "if (!has_turns_left(g.height)) ";
        expect_ended_early(exact_, altered(check + raises, raises), job);
    }
}

TEST_F(Kernels, ThatSayWhenTheirLoopsRunOut) {
    const std::string source =
        altered("while (rest != 0u) rest = rest >> 16;", "rest = rest >> 16;");
    EXPECT_THROW(run(plan_, source), DeviceError);
    EXPECT_THROW(run(exact_, source), DeviceError);
}

TEST_F(Kernels, ThatDoNotCompileAreAnErrorWithTheBuildLog) {
    const std::string what = error_of(plan_, altered("u32 passed = 0u;", "u32 passed = nonsense;"));
    EXPECT_NE(what.find("clBuildProgram failed with CL_BUILD_PROGRAM_FAILURE (-11)"),
              std::string::npos)
        << what;
    EXPECT_NE(what.find("nonsense"), std::string::npos) << what;
    EXPECT_NE(what.find(list_devices().front().name), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
}

TEST_F(Kernels, ThatAreMissingAreAnErrorWithTheirCall) {
    const std::string what = error_of(plan_, altered("kernel void grow(", "kernel void shrink("));
    EXPECT_NE(what.find("clCreateKernel failed with CL_INVALID_KERNEL_NAME (-46)"),
              std::string::npos)
        << what;
}

TEST_F(Kernels, RunOnTheDeviceThatTheResultNames) {
    Request request;
    request.radius = 0.1;
    request.backend = "opencl";
    const Result result = sample(request);
    EXPECT_EQ(result.backend, "opencl");
    bool is_listed = false;
    for (const DeviceEntry& entry : list_devices()) is_listed |= entry.name == result.device;
    EXPECT_TRUE(is_listed) << result.device;
}

TEST_F(Kernels, RefuseARoundLargerThanTheDevicesLargestBuffer) {
    Request request;
    request.radius = 0.1;
    request.round_size = 4'000'000'000;
    request.backend = "opencl";
    try {
        sample(request);
        FAIL() << "accepted";
    } catch (const BadRequest& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find("round-size 4000000000: must be at most "), 0u) << what;
    }
}

}  // namespace
}  // namespace lacuna::opencl

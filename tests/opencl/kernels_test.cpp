// The kernels do the work, and nothing else does: launches are counted, and wrong kernels noticed.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/scenes.h"
#include "generate.h"
#include "opencl/make_backend.h"

namespace lacuna::opencl {
namespace {

std::string altered(const std::string& from, const std::string& to) {
    std::string source = kernel_source();
    const std::size_t at = source.find(from);
    EXPECT_NE(at, std::string::npos) << "the kernels no longer have: " << from;
    if (at != std::string::npos) source.replace(at, from.size(), to);
    return source;
}

// What DeviceError says of a backend made from the source; empty when nothing was thrown.
std::string error_of(const Plan& plan, const std::string& source) {
    try {
        make_backend(plan, {}, {}, {source, nullptr});
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "";
}

class Kernels : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("opencl"); }

    Outcome run(const std::string& source, std::uint64_t* launches = nullptr) {
        const auto backend = make_backend(plan_, {}, {}, {source, launches});
        Observer nobody;
        return generate(plan_, *backend, nobody);
    }
    std::vector<Sample> on_cpu() {
        Observer nobody;
        return generate(plan_, *cpu::make_backend(plan_, {}), nobody).samples;
    }

    const Plan plan_ = tests::plan_of(0.03, 6, Boundary::torus);
};

TEST_F(Kernels, AreLaunchedAFewTimesARoundNeverOnceASample) {
    std::uint64_t launches = 0;
    const Outcome outcome = run(kernel_source(), &launches);
    EXPECT_EQ(outcome.samples, on_cpu());
    // locate, sort_columns, eight passes, gather, subtract; and what is left of the start.
    EXPECT_GE(launches, 12 * outcome.rounds);
    EXPECT_LE(launches, 16 * outcome.rounds + 10);
}

TEST_F(Kernels, ThatAreWrongAreNoticed) {
    const std::vector<Sample> right = on_cpu();
    const std::pair<const char*, const char*> faults[] = {
        {"span.x + rank, line", "span.x + rank / 2u, line"},
        {"if (other.w >= candidate.w) continue;", "if (other.w <= candidate.w) continue;"},
        {"return waits ? FATE_UNDECIDED", "return false ? FATE_UNDECIDED"},
        {"window < windows", "window < 1u"},
        {"if (bottom > 0u) fits", "if (false) fits"},
        {"if (top < g.height && fits)", "if (false)"},
        {"y - reach + 1u : 0u", "y - reach + 1000u : 0u"},
    };
    for (const auto& [from, to] : faults)
        EXPECT_NE(run(altered(from, to)).samples, right) << from << " became " << to;
}

TEST_F(Kernels, ThatDoNotCompileAreAnErrorWithTheBuildLog) {
    const std::string what = error_of(plan_, altered("u32 rank = draw.y;", "u32 rank = nonsense;"));
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

// Tests of OpenCL alone: errors of kernels that do not compile, and small sets for Oclgrind.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/opencl/device.h"
#include "backends/opencl/opencl_backend.h"
#include "backends/scenes.h"
#include "refusal.h"
#include "sampling/generate.h"

namespace lacuna::opencl {
namespace {

std::string altered(const std::string& from, const std::string& to) {
    std::string source(source_of("locate", kernel_sources()));
    const std::size_t at = source.find(from);
    EXPECT_NE(at, std::string::npos) << "the kernels no longer have: " << from;
    if (at != std::string::npos) source.replace(at, from.size(), to);
    return source;
}

// The message of the DeviceError for a set made from the source; empty when nothing was thrown.
std::string error_of(const Plan& plan, const std::string& source) {
    Observer nobody;
    try {
        generate(plan, *make_backend(plan, {}, {}, {{source}}), nobody);
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "";
}

std::vector<Sample> samples_of(const Plan& plan, Backend& backend) {
    Observer nobody;
    return generate(plan, backend, nobody).samples;
}

class Kernels : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("opencl"); }

    const Plan plan_ = tests::plan_of(0.03, 6, Boundary::torus);
};

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
    const std::string what =
        error_of(plan_, altered("KERNEL(locate, serve_locate, SlabArguments, LOCATE_BINDINGS)",
                                "#if 0\nKERNEL(locate, gone)\n#endif"));
    EXPECT_NE(what.find("clCreateKernel failed with CL_INVALID_KERNEL_NAME (-46)"),
              std::string::npos)
        << what;
}

TEST_F(Kernels, RunOnTheDeviceThatTheResultNames) {
    Request request;
    request.radius = 0.1;
    request.run_on.backend = "opencl";
    const Result result = sample(request);
    EXPECT_EQ(result.backend, "opencl");
    bool is_listed = false;
    for (const DeviceEntry& entry : list_devices()) is_listed |= entry.name == result.device;
    EXPECT_TRUE(is_listed) << result.device;
}

TEST_F(Kernels, RefuseARoundLargerThanTheDevicesLargestBuffer) {
    Request request;
    request.radius = 0.1;
    request.paper2011.round_size = 4'000'000'000;
    request.run_on.backend = "opencl";
    const std::string what = tests::refusal_of([&] { sample(request); });
    EXPECT_TRUE(what.starts_with("round-size 4000000000: must be at most ")) << what;
}

struct SmallSet {
    const char* name;
    Metric metric;
    Boundary boundary;
    std::uint32_t slices;
};

// Run under Oclgrind too, see oclgrind.cmake. Oclgrind takes a new buffer for uninitialized where
// one was released before. So each test makes one backend in its process, and rounds of one size.
class CellsSmallSet : public testing::TestWithParam<SmallSet> {
protected:
    void SetUp() override {
        for (const DeviceEntry& entry : list_devices())
            if (entry.unusable.empty()) return;
        if (tests::is_required("opencl")) FAIL() << "LACUNA_REQUIRE has opencl, but no device";
        GTEST_SKIP() << "no device";
    }
};

TEST_P(CellsSmallSet, IsTheCpusToo) {
    Plan plan =
        tests::cells_plan(tests::ramp_field(7, 9), 0.06, 4, GetParam().metric, GetParam().boundary);
    plan.round_size = 16;
    const std::vector<Sample> right = samples_of(plan, *cpu::make_backend(plan, {}));
    EXPECT_GT(right.size(), 16u);
    EXPECT_TRUE(samples_of(plan, *make_backend(plan, {}, {0, GetParam().slices})) == right);
}

INSTANTIATE_TEST_SUITE_P(Metric, CellsSmallSet,
                         testing::Values(SmallSet{"min", Metric::min, Boundary::torus, 1},
                                         SmallSet{"mean", Metric::mean, Boundary::box, 3},
                                         SmallSet{"max", Metric::max, Boundary::torus, 2}),
                         [](const auto& set) { return set.param.name; });

}  // namespace
}  // namespace lacuna::opencl

// Backends under test, by name. If this machine lacks a backend, its tests are skipped, with the
// reason; if the environment variable LACUNA_REQUIRE holds its name, they fail instead.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "backends/backend.h"
#include "backends/cpu/cpu_backend.h"
#include "backends/device/layout.h"
#include "plan/make_plan.h"
#include "required.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/opencl_backend.h"
#endif
#ifdef LACUNA_VULKAN
#include "backends/vulkan/vulkan_backend.h"
#endif

namespace lacuna::tests {

inline const auto kDeviceBackends = testing::Values("opencl", "vulkan");
inline const auto kParallelBackends = testing::Values("cpu", "opencl", "vulkan");

inline std::string name_of_parameter(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

// Throws Unavailable.
inline std::unique_ptr<Backend> make_backend(const std::string& name, const Plan& plan,
                                             [[maybe_unused]] device::Tuning tuning = {}) {
    const Placement anywhere;
    if (name == "cpu") return cpu::make_backend(plan, anywhere);
#ifdef LACUNA_OPENCL
    if (name == "opencl") return opencl::make_backend(plan, anywhere, tuning);
#endif
#ifdef LACUNA_VULKAN
    if (name == "vulkan") return vulkan::make_backend(plan, anywhere, tuning);
#endif
    throw Unavailable("backend " + name + ": this build was made without it");
}

// Why the backend cannot be tested here; empty when it can.
inline std::string why_missing(const std::string& name) {
    Request request;
    request.radius = 0.5;
    try {
        make_backend(name, make_plan(request));
    } catch (const Unavailable& reason) {
        return reason.what();
    }
    return "";
}

// For SetUp: gtest does not run the test's body after a skip or a failure.
inline void skip_or_fail_without(const std::string& name) {
    const std::string reason = why_missing(name);
    if (reason.empty()) return;
    if (is_required(name)) FAIL() << "LACUNA_REQUIRE has " << name << ", but: " << reason;
    GTEST_SKIP() << reason;
}

// The base of tests that take the backend's name: INSTANTIATE_TEST_SUITE_P with kDeviceBackends.
class OnBackend : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override { skip_or_fail_without(GetParam()); }
};

}  // namespace lacuna::tests

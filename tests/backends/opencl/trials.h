// Runs of kernels that a test has changed, or whose launches it counts.
#pragma once

#include <gtest/gtest.h>
#include <cstdint>
#include <string>
#include <vector>

#include "backends/cpu/make_backend.h"
#include "backends/opencl/make_backend.h"
#include "generate.h"

namespace lacuna::opencl {

// The source with one place changed.
inline std::string altered(std::string source, const std::string& from, const std::string& to) {
    const std::size_t at = source.find(from);
    EXPECT_NE(at, std::string::npos) << "the kernels no longer have: " << from;
    if (at != std::string::npos) source.replace(at, from.size(), to);
    return source;
}

// What DeviceError says of a backend made from the source; empty when nothing was thrown.
inline std::string error_of(const Plan& plan, const std::string& source) {
    try {
        make_backend(plan, {}, {}, {source, nullptr});
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "";
}

// Wrong kernels need not come to an end.
struct ThirtyRounds : Observer {
    bool keep_going(const Progress& progress) override { return progress.rounds <= 30; }
};

// Nothing where a set is not done after thirty rounds.
inline Outcome run(const Plan& plan, const std::string& source, std::uint64_t* launches = nullptr,
                   const device::Tuning& tuning = {}) {
    const auto backend = make_backend(plan, {}, tuning, {source, launches});
    ThirtyRounds observer;
    try {
        return generate(plan, *backend, observer);
    } catch (const Cancelled&) {
        return {};
    }
}

// Of kernels one of whose loops was ended early: the error names the job, and no set is made.
inline void expect_ended_early(const Plan& plan, const std::string& source,
                               const std::string& job) {
    try {
        run(plan, source);
        FAIL() << job << " went unnoticed";
    } catch (const DeviceError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(": " + job +
                            ": a loop was ended early by the driver: use fewer points, or another "
                            "backend"),
                  std::string::npos)
            << what;
    }
}

inline std::vector<Sample> on_cpu(const Plan& plan) {
    Observer nobody;
    return generate(plan, *cpu::make_backend(plan, {}), nobody).samples;
}

}  // namespace lacuna::opencl

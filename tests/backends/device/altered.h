// Kernels with a planted fault, on both device APIs: the text of kernels/, changed and compiled.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "backends/available.h"
#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/queue.h"
#include "plan/plan.h"
#include "sampling/generate.h"

namespace lacuna::tests {

// Replaces the first `from` in a file of kernels/ by `to`, in one kernel or in all that include the
// file.
struct Fault {
    const char* file;
    const char* from;
    const char* to;
    const char* kernel = "";
};

// A test's faulty kernels run once, so drivers compile them without optimisation, in half the time.
class OnFaultyBackend : public OnBackend {
protected:
    void SetUp() override;
};

// The device backend with the fault. Throws std::runtime_error if the text is not in the file, if
// the kernel does not include the file, or if it does not compile.
std::unique_ptr<Backend> make_faulty(const std::string& backend, const Plan& plan,
                                     const Fault& fault, const device::Tuning& tuning = {});

// The same for the kernels of relax.
std::unique_ptr<device::Queue> open_faulty_queue(const std::string& backend, const Fault& fault);

// The outcome is empty if a set takes more than `most` rounds: wrong kernels may never end.
inline constexpr std::uint64_t kMostRounds = 30;
Outcome run_rounds(const Plan& plan, Backend& backend, std::uint64_t most = kMostRounds);
Outcome run_on_cpu(const Plan& plan);

}  // namespace lacuna::tests

// Kernels with a planted fault, on both device APIs: the text of kernels/, changed and compiled.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

// The same on surfaces and in volumes.
std::unique_ptr<space::SpaceBackend> make_faulty_in_space(const std::string& backend,
                                                          const Plan& plan, const Fault& fault);

// The same for the kernels of relax.
std::unique_ptr<device::Queue> open_faulty_queue(const std::string& backend, const Fault& fault);

inline constexpr std::uint64_t kMostRounds = 30;
struct SomeRounds : Observer {
    explicit SomeRounds(std::uint64_t most) : most_(most) {}
    bool keep_going(const Progress& progress) override { return progress.rounds <= most_; }
    std::uint64_t most_;
};

// The outcome is empty if a set takes more than `most` rounds: wrong kernels may never end.
template <typename Placed>
OutcomeOf<Placed> run_rounds(const Plan& plan, BackendOf<Placed>& backend,
                             std::uint64_t most = kMostRounds) {
    SomeRounds observer(most);
    std::vector<Placed> all;
    const auto keep = [&](std::span<const Placed> samples) {
        all.insert(all.end(), samples.begin(), samples.end());
    };
    try {
        OutcomeOf<Placed> outcome = generate<Placed>(plan, backend, observer, keep);
        outcome.samples = std::move(all);
        return outcome;
    } catch (const Cancelled&) {
        return {};
    }
}
Outcome run_on_cpu(const Plan& plan);

}  // namespace lacuna::tests

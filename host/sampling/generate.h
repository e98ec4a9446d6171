// The loop: rounds of draws until the free space is empty (docs/design.md, section 3).
#pragma once

#include <lacuna/lacuna.h>
#include <cstddef>
#include <span>
#include <string>

#include "backends/backend.h"
#include "plan/checked_request.h"
#include "plan/plan.h"
#include "rounds/round.h"

namespace lacuna {

// The result of a run, and the backend and device that made it.
struct Run {
    Outcome outcome;
    std::string backend;
    std::string device;
};

// Runs the plan on the backend that the request asks for. Throws Unavailable, Cancelled,
// DeviceError.
Run run_on_backend(const Request& request, const Plan& plan, Observer& observer);
Run run_on_backend(const Request& request, const Plan& plan, Observer& observer,
                   const TakeSamples& take);

// The points of a result: the kept ones of the domain first, with room for `expected` more; then
// samples of a plan, each with its class if there are classes. cut_points leaves out all but the
// first `count`.
void begin_points(const CheckedRequest& request, std::size_t expected, Result& result);
void append_points(const Plan& plan, std::span<const Sample> samples, Workers& workers,
                   Result& result);
void cut_points(std::size_t count, Result& result);

// Makes a maximal set, or its first plan.limit samples. Throws Cancelled, DeviceError.
Outcome generate(const Plan& plan, Backend& backend, Observer& observer);
template <typename Placed>
OutcomeOf<Placed> generate(const Plan& plan, BackendOf<Placed>& backend, Observer& observer,
                           const TakeSamplesOf<Placed>& take);

}  // namespace lacuna

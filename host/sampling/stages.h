// A set that is made in several runs, each of which keeps all samples of those before.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <vector>

#include "base/polling.h"
#include "base/workers.h"
#include "plan/checked_request.h"
#include "plan/plan.h"

namespace lacuna {

class Stages {
public:
    // `expected`: about how many points there will be, for the observer's progress.
    Stages(const CheckedRequest& request, Observer& observer, std::uint64_t expected);

    // Runs the request of a stage, which has a radius field, and adds what it makes to the result.
    // Ends early at the request's limit, or when one class has as many new samples as its limit.
    void run(const CheckedRequest& stage, const Poll& poll,
             const std::vector<std::uint64_t>& class_limits = {});

    // What all stages have made. Radius, scale and whether it is maximal are those of the last one.
    Result& result() { return result_; }

private:
    Observer& observer_;
    std::uint64_t expected_;
    Workers workers_;
    Result result_;
    std::vector<Sample> samples_;
};

}  // namespace lacuna

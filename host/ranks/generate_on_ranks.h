// The loop of generate.h, run by several ranks together. Any number of them gives the same samples.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>

#include "backends/backend.h"
#include "plan/plan.h"
#include "ranks/border.h"
#include "ranks/ranks.h"
#include "ranks/strip.h"

namespace lacuna {

// Receives the samples of each round that this rank made.
class Sink {
public:
    virtual ~Sink() = default;

    // Samples of `plan` follow; samples that were taken before are void.
    virtual void begin(const Plan& plan) = 0;
    // Takes this rank's samples of a round, in units of the domain, and the ascending numbers of
    // their draws; the round has `draws` draws. Over all ranks a round's samples are ordered by
    // number, and rounds follow each other. Samples beyond the plan's limit are to be dropped.
    // Every rank calls it once in each round, even without samples.
    virtual void take(std::span<const Sample> samples, std::span<const std::uint32_t> numbers,
                      std::uint32_t draws) = 0;
};

struct OutcomeOnRanks {
    std::uint64_t samples = 0;  // of all ranks, at most the limit
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    bool maximal = false;
    // The next two are this rank's alone.
    std::uint64_t own_samples = 0;  // may exceed the limit
    Border::Tally border;
};

// Every rank calls it with its strip of the plan and a backend for the strip. Observers get the
// counts of all ranks, and any of them can cancel all ranks. `depth`: see Border. Throws Cancelled,
// DeviceError, and exceptions of the sink.
OutcomeOnRanks generate_on_ranks(const Plan& plan, const Strip& strip, Backend& backend,
                                 Ranks& ranks, Sink& sink, Observer& observer,
                                 std::uint32_t depth = Border::kDepth);

}  // namespace lacuna

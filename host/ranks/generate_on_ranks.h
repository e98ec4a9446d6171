// The loop of generate.h, made by several ranks together: the same samples for any number of them.
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

// Where the samples of a round go that one rank has made.
class Sink {
public:
    virtual ~Sink() = default;

    // Samples of this plan follow; what was taken before, if anything, is void.
    virtual void begin(const Plan& plan) = 0;
    // The samples, in units of the domain, of some of the round's draws, so many in all, and the
    // draws' numbers, which ascend. All ranks' samples of a round come after those of the rounds
    // before it, in the order of their numbers; those beyond the plan's limit are not wanted. Every
    // rank calls it once a round, with what it has.
    virtual void take(std::span<const Sample> samples, std::span<const std::uint32_t> numbers,
                      std::uint32_t draws) = 0;
};

struct OutcomeOnRanks {
    std::uint64_t samples = 0;  // of all ranks, at most the limit
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    bool maximal = false;
    // Of this rank alone.
    std::uint64_t own_samples = 0;  // before the limit
    Border::Tally border;
};

// Every rank calls it with its own strip of the plan and a backend for that. Observers hear of all
// ranks' samples; any of them cancels the run of all. `depth`: see Border. Throws Cancelled,
// DeviceError, and what the sink throws.
OutcomeOnRanks generate_on_ranks(const Plan& plan, const Strip& strip, Backend& backend,
                                 Ranks& ranks, Sink& sink, Observer& observer,
                                 std::uint32_t depth = Border::kDepth);

}  // namespace lacuna

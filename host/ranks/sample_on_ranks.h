// lacuna::sample for ranks: each calls it with the same request, and serves its strip.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>

#include "ranks/generate_on_ranks.h"
#include "ranks/ranks.h"

namespace lacuna {

struct ResultOnRanks {
    OutcomeOnRanks outcome;
    double radius = 0;  // asked for, or chosen for a count
    std::uint32_t lines_per_radius = 0;
    std::string backend;  // this rank's
    std::string device;
};

// Throws BadRequest for what is wrong with any request, and for what ranks do not make.
void check_request_on_ranks(const Request& request);
// So many can share the set: each takes a strip two radii wide or more.
std::uint32_t most_ranks(const Request& request);

// The request was checked, and the ranks are no more than that. Throws FailedTogether where one of
// them has no such backend, and what generate_on_ranks throws.
ResultOnRanks sample_on_ranks(const Request& request, Ranks& ranks, Sink& sink, Observer& observer);

}  // namespace lacuna

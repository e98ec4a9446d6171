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

// Throws BadRequest where a rank alone could have, before any rank calls another: for what ranks do
// not make, and where the domain has too few columns for so many. Then what generate_on_ranks and
// make_backend throw.
void check_request_on_ranks(const Request& request, std::uint32_t ranks);
ResultOnRanks sample_on_ranks(const Request& request, Ranks& ranks, Sink& sink, Observer& observer);

}  // namespace lacuna

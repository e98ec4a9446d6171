// lacuna::sample for ranks. Every rank calls it with the same request and makes its strip.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>

#include "ranks/generate_on_ranks.h"
#include "ranks/ranks.h"

namespace lacuna {

struct ResultOnRanks {
    OutcomeOnRanks outcome;
    double radius = 0;  // the request's, or chosen for its count
    std::uint32_t lines_per_radius = 0;
    std::string backend;  // the backend of this rank
    std::string device;
};

// Throws BadRequest if the request is wrong, or asks for something that ranks cannot make.
void check_request_on_ranks(const Request& request);
// Most ranks for the request: each needs a strip at least two radii wide.
std::uint32_t most_ranks(const Request& request);

// Needs a checked request and at most most_ranks() ranks. Throws FailedTogether if one of them does
// not have the backend, and what generate_on_ranks throws.
ResultOnRanks sample_on_ranks(const Request& request, Ranks& ranks, Sink& sink, Observer& observer);

}  // namespace lacuna

// --report: what was asked for, what came of it, and what it cost, as JSON.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>

#include "cli/options/common_options.h"
#include "cli/reports/json.h"
#include "pictures/importance.h"

namespace lacuna::cli {

// All of the request that decides which points are made.
Json what_decides(const Request& request, const Result& result);

// How a picture became importance.
Json json_of_importance(const pictures::Importance& importance);

// Seconds are those of the sampling, without the writing of files. `more` is merged into what there
// is to say of every set.
std::string report_of(const Request& request, const Made& made);
std::string report_of(const Request& request, const Made& made, const Json& more);

// Of many sets of one request: how many points they have, and what they took together.
struct ManyMade {
    std::uint64_t first_seed = 0;
    std::uint64_t last_seed = 0;
    std::uint64_t sets = 0;
    std::uint64_t points = 0;
    std::uint64_t least = 0;  // points of a set
    std::uint64_t most = 0;
    std::uint64_t maximal = 0;  // sets
    Result last;                // without its points
    double seconds = 0;         // the writing of files included
};
std::string many_report(const Request& request, const ManyMade& made);

// Of points that were read and only relaxed.
std::string relax_report(const Json& request, const Made& made, const Json& more);

}  // namespace lacuna::cli

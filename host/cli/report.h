// --report: what was asked for, what came of it, and what it cost, as JSON.
#pragma once

#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/common_options.h"
#include "pictures/importance.h"

namespace lacuna::cli {

using Json = nlohmann::ordered_json;

// All of the request that decides which points are made.
Json what_decides(const Request& request, const Result& result);

// How a picture became importance.
Json json_of_importance(const pictures::Importance& importance);

// Seconds are those of the sampling, without the writing of files. `more` is merged into what there
// is to say of every set.
std::string report_of(const Request& request, const Made& made);
std::string report_of(const Request& request, const Made& made, const Json& more);

// Of points that were read and only relaxed.
std::string relax_report(const Json& request, const Made& made, const Json& more);

}  // namespace lacuna::cli

// --report: what was asked for, what came of it, and what it cost, as JSON.
#pragma once

#include <lacuna/lacuna.h>
#include <string>

#include "cli/stopwatch.h"

namespace lacuna::cli {

// `total_seconds` are those of the sampling, without the writing of files.
std::string report_of(const Request& request, const Result& result, const Stopwatch& stopwatch,
                      double total_seconds);

}  // namespace lacuna::cli

// A comparison as tables on a terminal, as JSON, and as a bar chart.
#pragma once

#include <string>

#include "cli/commands/comparison.h"
#include "drawing/medium.h"
#include "files/point_files.h"

namespace lacuna::cli {

// A table of times, memory and agreement, a table of seconds by verb, and then the hash of the
// points and the differences.
std::string text_of(const Comparison& comparison);

// The same as JSON, with the seconds of every run.
std::string json_of(const Comparison& comparison, const Request& request);

// A bar for each entry's median, divided into its verbs, and a line from fastest to slowest run.
std::string draw_chart(const Comparison& comparison, drawing::Medium medium);

}  // namespace lacuna::cli

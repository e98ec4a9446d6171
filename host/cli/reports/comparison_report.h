// A comparison as tables on a terminal, as JSON, and as a bar chart.
#pragma once

#include <string>

#include "cli/commands/comparison.h"
#include "drawing/medium.h"
#include "files/point_files.h"

namespace lacuna::cli {

// Times, memory and agreement; then seconds by verb; then what does not agree, or the hash.
std::string text_of(const Comparison& comparison);

// Every run's seconds, and the rest.
std::string json_of(const Comparison& comparison, const Request& request);

// A bar for each entry's median, with its spread, parted by verbs.
std::string draw_chart(const Comparison& comparison, drawing::Medium medium);

}  // namespace lacuna::cli

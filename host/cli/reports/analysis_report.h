// What `lacuna analyze` says of point sets: as lines to be read, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "analysis/analyse.h"

namespace lacuna::cli {

// A number a line, behind its name.
std::string text_of(const analysis::Analysis& analysis);

// All numbers and curves; what is not known is null. `files` are the names as given.
std::string json_of(const analysis::Analysis& analysis, const std::vector<std::string>& files);

}  // namespace lacuna::cli

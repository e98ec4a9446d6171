// The output of `lacuna analyze`: as lines of text, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "analysis/analyse.h"

namespace lacuna::cli {

// One number on each line, behind its name.
std::string text_of(const analysis::Analysis& analysis);

// All numbers and curves; numbers that do not exist are null. `files` are the names as given.
std::string json_of(const analysis::Analysis& analysis, const std::vector<std::string>& files);

}  // namespace lacuna::cli

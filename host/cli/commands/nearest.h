// "Did you mean": of the words that would have been right, the one that is nearest.
#pragma once

#include <string>
#include <vector>
#include "cli/app_fwd.h"

namespace lacuna::cli {

std::vector<std::string> names_of_commands(const CLI::App& app);
// With their dashes.
std::vector<std::string> names_of_options(const CLI::App& command);

// ", did you mean WORD?" with the word of `known` that takes the fewest letters to change, add,
// leave out or swap with the next; empty if it takes more than two, or a third of the word.
std::string nearest_text(const std::string& word, const std::vector<std::string>& known);

}  // namespace lacuna::cli

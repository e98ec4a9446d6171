// "Did you mean": suggests the known word that is most like a mistyped one.
#pragma once

#include <string>
#include <vector>
#include "cli/app_fwd.h"

namespace lacuna::cli {

std::vector<std::string> names_of_commands(const CLI::App& app);
// Names with their dashes.
std::vector<std::string> names_of_options(const CLI::App& command);

// ", did you mean WORD?" with the word of `known` that has the least edit distance from `word`.
// Empty if the distance is more than two letters or a third of the word.
std::string nearest_text(const std::string& word, const std::vector<std::string>& known);

}  // namespace lacuna::cli

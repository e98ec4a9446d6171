// What may stand at a place of a command line: for the completions of shells, and for "did you
// mean".
#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace lacuna::cli {

std::vector<std::string> names_of_commands(const CLI::App& app);
// Names with their dashes.
std::vector<std::string> names_of_options(const CLI::App& command);

// The words that may stand where the last one of `typed` does, which may be unfinished; the name of
// the program is not among them. A line each, with a tab and a description after some. Empty where
// the table of options knows no words, as for paths and numbers.
std::string words_at(const CLI::App& app, std::span<const std::string> typed);

// ", did you mean WORD?" with the word of `known` that has the least edit distance from `word`.
// If the distance is more than two letters or a third of the word, with the options that have a
// word which begins like it, as --paper-size has for --paper. Empty if there are none.
std::string nearest_text(const std::string& word, const std::vector<std::string>& known);

}  // namespace lacuna::cli

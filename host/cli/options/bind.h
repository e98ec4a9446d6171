// Adds a command with its options, from the table of options, and binds each to where its value
// goes.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/options/given_files.h"
#include "recipes/options.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace lacuna::cli {

using recipes::CommandLine;

// Where a value goes: a variable, or a function that is called with its text.
using Take = std::function<void(const std::string& text)>;
using Target = std::variant<bool*, Boundary*, double*, std::optional<double>*, std::uint32_t*,
                            std::optional<std::uint32_t>*, std::uint64_t*,
                            std::optional<std::uint64_t>*, std::string*, std::vector<std::string>*,
                            std::optional<Mode>*, std::optional<Metric>*, Take>;

// The targets of options by their names. There may be more than the command has options.
using Targets = std::map<std::string_view, Target>;

// Adds the command with all options that the table gives it; each must have a target, and all that
// targets refer to must outlive the command. Once the command line has been read, and
// recipes::refuse_pairs() lets it pass, `run` is called.
void add_command(CLI::App& app, recipes::Commands which, const std::string& description,
                 const Targets& targets, const std::function<void(const CommandLine&)>& run);

// The files that the command line names, which are read.
std::vector<GivenFile> files_read(const CommandLine& line);

}  // namespace lacuna::cli

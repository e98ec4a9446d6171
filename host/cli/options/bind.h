// Adds a command with its options, from the table of options, and binds each to where its value
// goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/options/given_files.h"
#include "options/options.h"
#include "options/targets.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace lacuna::cli {

using options::CommandLine;
using options::take_by;
using options::Targets;

// Adds the command with all options that the table gives it; each must have a target, and all that
// targets refer to must outlive the command. There may be more targets than options. Once the
// command line has been read, and options::refuse_pairs() lets it pass, `run` is called.
void add_command(CLI::App& app, options::Commands which, const std::string& description,
                 const Targets& targets, const std::function<void(const CommandLine&)>& run);

// The files that the command line names, which are read.
std::vector<GivenFile> files_read(const CommandLine& line);

}  // namespace lacuna::cli

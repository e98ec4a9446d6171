// The program lacuna: its subcommands.
#pragma once

#include <functional>

#include "cli/reports/comparison.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace lacuna::cli {

// Runs the command line, prints errors on standard error, and returns the exit code. `compare`
// makes its sets with `sampler`.
int run_commands(int argc, char** argv, const Sampler& sampler);

// Each adds a command to `app`, which runs it after parsing. It throws what the library and files
// throw, and CheckFailed where a check that was asked for fails.
void add_sample(CLI::App& app);
void add_stipple(CLI::App& app);
void add_relax_command(CLI::App& app);
void add_order(CLI::App& app);
void add_verify(CLI::App& app);
void add_analyze(CLI::App& app);
void add_reproduce(CLI::App& app);
void add_compare(CLI::App& app, const Sampler& sampler);
void add_mask(CLI::App& app);
void add_devices(CLI::App& app);
// Runs other commands, which `add_commands` adds to an app of its own.
void add_again(CLI::App& app, const std::function<void(CLI::App&)>& add_commands);

}  // namespace lacuna::cli

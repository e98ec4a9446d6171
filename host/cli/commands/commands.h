// The program lacuna: its subcommands.
#pragma once

#include "cli/commands/comparison.h"

namespace lacuna::cli {

// Runs the command line, prints errors on standard error, and returns the exit code. `compare`
// makes its sets with `sampler`.
int run_commands(int argc, char** argv, const Sampler& sampler);

}  // namespace lacuna::cli

// The program lacuna: its subcommands.
#pragma once

#include "cli/commands/comparison.h"

namespace lacuna::cli {

// Runs the command line, tells on standard error what went wrong, and returns the exit code. The
// sets that `compare` compares are made by `sampler`.
int run_commands(int argc, char** argv, const Sampler& sampler);

}  // namespace lacuna::cli

// `lacuna sample`: options to a request, the run, and what is written of it.
#pragma once

#include <CLI/CLI.hpp>

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws what lacuna::sample and the files
// throw.
void add_sample(CLI::App& app);

}  // namespace lacuna::cli

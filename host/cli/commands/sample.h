// `lacuna sample`: turns its options into a request, makes the set and writes it.
#pragma once

#include <lacuna/lacuna.h>

#include <functional>
#include <string>

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws what lacuna::sample and the files
// throw.
void add_sample(CLI::App& app);

// Each adds options to `command` that stipple does not have:
// --radius, --count, --domain
void add_size(CLI::App& command, Request& request);
// --mode, --lines-per-radius, --uniform-x, --snap
void add_mode(CLI::App& command, Request& request,
              const std::function<void(const std::string&)>& read_mode,
              const std::string& more_modes);

}  // namespace lacuna::cli

// `lacuna stipple`: turns a picture into dots, which are dense where it is dark.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws what lacuna::sample, the readers
// of pictures and the files throw.
void add_stipple(CLI::App& app);

}  // namespace lacuna::cli

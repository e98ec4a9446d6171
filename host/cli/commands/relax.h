// `lacuna relax`: moves the points of any set until their shares are equal.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws what lacuna::relax, the readers of
// points and pictures and the files throw.
void add_relax_command(CLI::App& app);

}  // namespace lacuna::cli

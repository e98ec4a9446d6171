// `lacuna relax`: moves the points of any set until their cells have equal capacity.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws BadRequest, files::FileError and
// what lacuna::relax throws.
void add_relax_command(CLI::App& app);

}  // namespace lacuna::cli

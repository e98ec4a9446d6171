// `lacuna reproduce`: makes the paper's tables and figures again and compares their numbers.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws BadRequest, files::FileError,
// Cancelled, and CheckFailed where a number is not within its band.
void add_reproduce(CLI::App& app);

}  // namespace lacuna::cli

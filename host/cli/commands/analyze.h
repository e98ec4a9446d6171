// `lacuna analyze`: spectrum and statistics of point sets, as numbers and as a plot sheet.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws BadRequest, files::FileError and
// Cancelled.
void add_analyze(CLI::App& app);

}  // namespace lacuna::cli

// `lacuna order`: puts points that are there already into a progressive order.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws BadRequest and files::FileError.
void add_order(CLI::App& app);

}  // namespace lacuna::cli

// `lacuna verify`: proves or refutes that the points of a file are a maximal Poisson-disk set.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing. Throws BadRequest, files::FileError and
// CheckFailed.
void add_verify(CLI::App& app);

}  // namespace lacuna::cli

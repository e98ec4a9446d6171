// `lacuna compare`: runs one request on every backend and device, and compares points and times.
#pragma once

#include "cli/app_fwd.h"
#include "cli/commands/comparison.h"

namespace lacuna::cli {

// Adds the command to `app`, which runs it after parsing; its sets are made by `sampler`. Throws
// what lacuna::sample, the readers of pictures and the files throw, and CheckFailed when a result
// differs.
void add_compare(CLI::App& app, const Sampler& sampler);

}  // namespace lacuna::cli

// The origin of a set for files: the request, and a command line that makes the set again.
#pragma once

#include "cli/app_fwd.h"

#include "cli/options/common_options.h"
#include "cli/reports/report.h"
#include "files/point_files.h"

namespace lacuna::cli {

// Options that decide no point are left out (outputs, backend, device, threads), so that the bytes
// of a file are the same wherever the set was made. `more` is merged into the options.
files::Origin origin_of(const CLI::App& command, const Request& request, const Result& result,
                        const Json& more);
files::Origin origin_of(const CLI::App& command, const Request& request, const Result& result);

}  // namespace lacuna::cli

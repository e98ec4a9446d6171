// `lacuna devices`: every backend's devices, and why one cannot be used.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

void add_devices(CLI::App& app);

}  // namespace lacuna::cli

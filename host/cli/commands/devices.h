// `lacuna devices`: lists every backend's devices, and why some cannot be used.
#pragma once

#include "cli/app_fwd.h"

namespace lacuna::cli {

void add_devices(CLI::App& app);

}  // namespace lacuna::cli

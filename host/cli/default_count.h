// How many dots a picture gets where nobody says.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>

#include "cli/drawing.h"

namespace lacuna::cli {

// With --dot-size, as many as it takes for their areas to sum to the picture's darkness. Without,
// one to 16 pixels of black, a grey pixel counting as much as it is dark, and the longer side as
// 512 to 2048 pixels. 1 to a million.
std::uint64_t default_count(const Field& field, const Request& request,
                            const DrawingOptions& options, const drawing::Style& style);

}  // namespace lacuna::cli

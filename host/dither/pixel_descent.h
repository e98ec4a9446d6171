// Moves the samples of mode pixels from pixel to pixel, until they are evenly spread.
#pragma once

#include <lacuna/domain.h>

#include <cstdint>
#include <vector>

#include "dither/pixel_shares.h"

namespace lacuna {

// `taken` says which pixels have a sample, row by row from the lowest. Their number stays the same.
// Full pixels keep their samples, and pixels without mass get none.
void descend_on_pixels(const Raster& raster, bool wraps, const PixelShares& shares,
                       std::vector<std::uint8_t>& taken);

}  // namespace lacuna

// Tiles of thresholds for dithering and for spreading an error as blue noise: at every level the
// pixels under it are spread evenly, also across the tile's edges. Link lacuna.
#pragma once

#include <lacuna/export.h>
#include <lacuna/run.h>

#include <cstdint>
#include <vector>

namespace LACUNA_API lacuna {

struct ThresholdMask {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    // Row by row: the rank of each pixel, each of 0 to columns * rows - 1 once. For every n the
    // pixels of rank under n are spread evenly. A threshold is (rank + 1/2) / (columns * rows).
    std::vector<std::uint32_t> ranks{};
};

// Makes a tile by void and cluster (Ulichney, "The void-and-cluster method for dither array
// generation", 1993). It begins with the pixels under a relaxed set of points. The Gaussian, by
// which a pixel crowds others, has a deviation of 1.5 pixels and, where under a tenth of the pixels
// are in the minority, one in proportion to their distance. The same sides and seed give the same
// ranks on every machine. Each side must be 8 to 1024. The time grows with the square of the number
// of pixels. Throws BadRequest for other sides; a CancelScope (lacuna/cancel.h) ends it early.
ThresholdMask threshold_mask(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed = 0);

}  // namespace lacuna

// Tiles of thresholds for dithering and for spreading an error as blue noise: at every level the
// pixels under it are spread evenly, also across the tile's edges, and from frame to frame. Link
// lacuna.
#pragma once

#include <lacuna/export.h>
#include <lacuna/run.h>

#include <cstdint>
#include <vector>

namespace LACUNA_API lacuna {

struct ThresholdMask {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t frames = 1;
    // Frame by frame and row by row: the rank of each pixel, each of 0 to columns * rows * frames -
    // 1 once. For every n the pixels of rank under n are spread evenly in each frame, and those on
    // one place evenly in time. A threshold is (rank + 1/2) / (columns * rows * frames).
    std::vector<std::uint32_t> ranks{};
};

// Makes a tile by void and cluster (Ulichney, "The void-and-cluster method for dither array
// generation", 1993). It begins with the pixels under a relaxed set of points. The Gaussian, by
// which a pixel crowds others, has a deviation of 1.5 pixels and, where under a tenth of the pixels
// are in the minority, one in proportion to their distance. With several frames a pixel also crowds
// those on its place in other frames, by a Gaussian of 1.9 frames, but no others (Wolfe et al.,
// "Spatiotemporal blue noise masks", 2022); after the last frame comes the first one again. The
// same sides, frames and seed give the same ranks on every machine. Each side must be 8 to 1024,
// and all frames together may have 1024 * 1024 pixels. The time grows with the square of the number
// of pixels. Throws BadRequest for others; a CancelScope (lacuna/cancel.h) ends it early.
ThresholdMask threshold_mask(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed = 0,
                             std::uint32_t frames = 1);

}  // namespace lacuna

// How a plan's memory is laid out on a device: slabs of whole lines, and the tables of a round.
// Common to all devices; no call of a device in here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"
#include "portable/kernels.h"

namespace lacuna::device {

// Lines [first_line, end_line), whose spans lie in one buffer. Several slabs keep each buffer below
// the device's limit.
struct Slab {
    std::uint32_t first_line;
    std::uint32_t end_line;
    std::uint32_t lines() const { return end_line - first_line; }
};

// Indices [begin, end).
struct Range {
    std::uint32_t begin;
    std::uint32_t end;
};

// For tests.
struct Tuning {
    std::uint64_t largest_slab_bytes = 0;  // 0: the device's limit; lower values make more slabs
    // In lines and exact: rows of the sample grid in a tile; 0: as the device needs.
    std::uint32_t rows_of_tile = 0;
    // In cells: work items that divide the lines near a sample; 0: as many as the device needs.
    std::uint32_t slices_of_sample = 0;
};

// Divides all lines into slabs of at most largest_bytes, but at least one line each.
std::vector<Slab> share_out(std::uint32_t lines, std::uint32_t capacity,
                            std::uint64_t largest_bytes);

// The sample grid of lines and exact on a device. In lines its cells are small enough that two
// samples never share one, although with x interpolated they may be half a strip closer than the
// radius. In other modes it has no cells.
GridShape grid_of(const Plan& plan);

// The tiles of a line (portable/kernels.h): as high as `rows` rows of the sample grid, or higher by
// a power of 2, so that a line has at most kMostTiles. A graphics card gets tiles of kRowsOfTile
// rows, so that it has many items with short loops. A processor gets one tile a line.
struct Tiles {
    std::uint32_t count = 0;   // of a line
    std::uint32_t height = 0;  // the last one may be lower
};
inline constexpr std::uint32_t kRowsOfTile = 64;  // with more, loops have over 256 turns
inline constexpr std::uint32_t kMostTiles = 256;
Tiles tiles_of(const Plan& plan, std::uint32_t rows);
// The number of free spans that a tile has room for at first. Few tiles ever need more; then the
// backend grows, and no span is lost.
std::uint32_t first_tile_capacity(const Plan& plan, Tiles tiles);
// The most samples of a round near a tile of a column of lines, for each span that a tile has room
// for.
inline constexpr std::uint32_t kSamplesNearSpan = 3;

portable::Geometry geometry_of(const Plan& plan, std::uint32_t columns, std::uint32_t capacity);

// The draws that fall on a slab's lines. The draws are sorted by line.
Range draws_of(const Slab& slab, std::span<const Draw> draws);

// outcomes[] of portable/kernels.h, from a snapshot's candidates and statuses: by the orders of
// draws, a bit for each sample, then a bit for each draw that samples of earlier rounds cover.
std::vector<std::uint32_t> outcomes_of(const Snapshot& snapshot);

// Converts spans between a snapshot and the device's form: `capacity` spans for each tile. A span
// that crosses the border of two tiles is divided there.
struct Packed {
    std::vector<Span> slots;
    std::vector<std::uint32_t> counts;   // of each tile
    std::vector<std::uint32_t> lengths;  // of each tile, the sum of its spans
};
Packed pack(const Slab& slab, Tiles tiles, const Snapshot& snapshot);
void unpack(const Slab& slab, Tiles tiles, std::span<const Span> slots,
            std::span<const std::uint32_t> span_counts, Snapshot& snapshot);

// The number of active boxes, or in space of bins, that there is room for, and of entries of
// neighbour lists. Sets of a million samples and more have 0.45 to 0.5 boxes a sample with one
// radius; with a radius field 2.2 to 2.5, and 2.1 to 2.7 entries.
std::uint64_t room_for_boxes(const Plan& plan);
std::uint64_t room_for_entries(const Plan& plan);

// Throws Unavailable, naming the device, if the plan needs more memory than memory_bytes or a
// buffer larger than largest_buffer_bytes.
void refuse_if_too_large(const std::string& device, const Plan& plan, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes);

// The same for given needs: the bytes of all buffers together, and of the largest one.
struct Needs {
    std::uint64_t bytes = 0;
    std::uint64_t largest = 0;
};
void refuse_if_too_large(const std::string& device, const Needs& needs, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes);

}  // namespace lacuna::device

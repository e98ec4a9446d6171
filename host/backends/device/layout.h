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
    // In cells: work items that divide the lines near a sample; 0: as many as the device needs.
    std::uint32_t slices_of_sample = 0;
};

// Divides all lines into slabs of at most largest_bytes, but at least one line each.
std::vector<Slab> share_out(std::uint32_t lines, std::uint32_t capacity,
                            std::uint64_t largest_bytes);

portable::Geometry geometry_of(const Plan& plan, std::uint32_t columns, std::uint32_t capacity);

// The draws that fall on a slab's lines. The draws are sorted by line.
Range draws_of(const Slab& slab, std::span<const Draw> draws);

// Column c gets the room [begins[c], begins[c + 1]) for all samples that may cut its lines. Its
// size is the number of draws in the column and its neighbours.
void find_near_begins(const Plan& plan, std::uint32_t columns,
                      std::span<const std::uint32_t> column_begins,
                      std::vector<std::uint32_t>& begins);

// Takes the samples of a round from the table of its draws, by order: a draw not admitted has x ==
// NO_SAMPLE and its status in y. Returns the number of draws that no earlier round covers.
std::uint64_t take_admitted(std::span<const Sample> by_order, std::vector<Sample>& samples);

// The table that take_admitted reads, from a snapshot's candidates and statuses.
std::vector<Sample> samples_by_order(const Snapshot& snapshot);

// Converts a slab's spans between a snapshot and the device's form, `capacity` spans a line.
std::vector<Span> pack(const Slab& slab, const Snapshot& snapshot);
void unpack(const Slab& slab, std::span<const Span> slots,
            std::span<const std::uint32_t> span_counts, Snapshot& snapshot);

// The number of active boxes that there is room for, and of entries of neighbour lists with a
// radius field. Sets of a million samples and more have 0.45 to 0.5 boxes a sample with one radius;
// with a radius field 2.2 to 2.5, and 2.1 to 2.7 entries.
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

// How a plan's memory is laid out on a device: slabs of whole lines, and the tables of a round.
// What the device backends share; no call of a device in here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"
#include "portable/kernels.h"

namespace lacuna::device {

// Lines [first_line, end_line), whose spans lie in one buffer, so that none is larger than the
// device allows.
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
    std::uint64_t largest_slab_bytes = 0;  // 0: what the device allows; lower values, more slabs
    // In cells: work items that share the lines near a sample; 0: as many as the device needs.
    std::uint32_t slices_of_sample = 0;
};

// All lines, as many a slab as fit into largest_bytes, at least one.
std::vector<Slab> share_out(std::uint32_t lines, std::uint32_t capacity,
                            std::uint64_t largest_bytes);

portable::Geometry geometry_of(const Plan& plan, std::uint32_t columns, std::uint32_t capacity);

// The draws of a slab's lines, which are their places; draws are sorted by place.
Range draws_of(const Slab& slab, std::span<const Draw> draws);

// begins[column] .. begins[column + 1] is room for all samples that may cut the column's lines:
// as many as the column and its neighbours have draws.
void find_near_begins(const Plan& plan, std::uint32_t columns,
                      std::span<const std::uint32_t> column_begins,
                      std::vector<std::uint32_t>& begins);

// The samples of a round, from those of its draws in order: draws not admitted have x == NO_SAMPLE
// and their status in y. Returns how many draws no sample of an earlier round covers.
std::uint64_t take_admitted(std::span<const Sample> by_order, std::vector<Sample>& samples);

// The same the other way round: what a snapshot's statuses make of its candidates, by order.
std::vector<Sample> samples_by_order(const Snapshot& snapshot);

// A slab's spans as the device holds them, `capacity` a line, from a snapshot and back into one.
std::vector<Span> pack(const Slab& slab, const Snapshot& snapshot);
void unpack(const Slab& slab, std::span<const Span> slots,
            std::span<const std::uint32_t> span_counts, Snapshot& snapshot);

// For how many active boxes there is to be room and, with a radius field, for how many entries of
// lists. In sets of a million samples and more 0.45 to 0.5 boxes a sample have been seen with one
// radius, and with a radius field 2.2 to 2.5, and 2.1 to 2.7 entries.
std::uint64_t room_for_boxes(const Plan& plan);
std::uint64_t room_for_entries(const Plan& plan);

// What the plan needs of a device that has so much memory and allows buffers so large: throws
// Unavailable, naming the device, when it is not there.
void refuse_if_too_large(const std::string& device, const Plan& plan, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes);

// The same of what anything else needs: all its buffers, and the largest.
struct Needs {
    std::uint64_t bytes = 0;
    std::uint64_t largest = 0;
};
void refuse_if_too_large(const std::string& device, const Needs& needs, std::uint64_t memory_bytes,
                         std::uint64_t largest_buffer_bytes);

}  // namespace lacuna::device

// The free space before the first sample, as spans, lengths and bits. All of it comes from
// first_spans(): a new rule about where samples may lie changes that function alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plan/plan.h"

namespace lacuna {

// The spans of the line where samples may lie: sorted, separate, none empty. In cells these are the
// parts above pixels with importance; in the other modes the whole height.
std::vector<Span> first_spans(const Plan& plan, std::uint32_t line);

// For each line the total length of its spans.
std::vector<std::uint32_t> first_free_lengths(const Plan& plan);

// The free length of every bin and, with a radius field, the width of every box.
struct FirstFree {
    explicit FirstFree(const Plan& plan);

    std::vector<std::uint32_t> lengths;
    std::vector<std::uint32_t> widths;
    std::vector<std::uint32_t> copy_ends;  // with classes: the boxes up to the end of each copy
};

// The number of boxes up to the end of each copy (plan/class_copies.h); empty with one class.
std::vector<std::uint32_t> copy_ends_of(const Plan& plan, std::span<const Box> boxes);

// The free space of the lines [first_line, end_line) as bits, in the format of Snapshot::bits. Each
// line has an even number of 32-bit words; the lowest y is the lowest bit of the first word.
std::vector<std::uint32_t> first_bits(const Plan& plan, std::uint32_t first_line,
                                      std::uint32_t end_line);
std::uint32_t words_per_line(const Plan& plan);

}  // namespace lacuna

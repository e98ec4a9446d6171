// What is free before the first sample, in spans, lengths and bits. All of it follows from
// first_spans: a new rule about where samples may lie changes that function alone.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna {

// The stretches of the line where samples may lie: sorted, apart, none empty. In cells those above
// pixels of some importance; in the other modes the whole height.
std::vector<Span> first_spans(const Plan& plan, std::uint32_t line);

// The total length of every line's.
std::vector<std::uint32_t> first_free_lengths(const Plan& plan);

// The free length of every place and, with a radius field, its width.
struct FirstFree {
    explicit FirstFree(const Plan& plan);

    std::vector<std::uint32_t> lengths;
    std::vector<std::uint32_t> widths;
};

// The same as bits of the lines [first_line, end_line), as Snapshot::bits has them: each line in an
// even number of words of 32 bits, the lowest y in the lowest bit of the first.
std::vector<std::uint32_t> first_bits(const Plan& plan, std::uint32_t first_line,
                                      std::uint32_t end_line);
std::uint32_t words_per_line(const Plan& plan);

}  // namespace lacuna

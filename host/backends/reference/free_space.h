// What the loop of reference.cpp asks of a mode: where samples may still be placed, and what one
// takes from that. A file each: lines.cpp, exact.cpp, cells.cpp, and
// exact_with_field.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "plan/plan.h"
#include "rounds/round_policy.h"

namespace lacuna::reference {

class FreeSpace {
public:
    virtual ~FreeSpace() = default;

    // Of the places that draws fall on: lines or boxes.
    virtual std::span<const std::uint32_t> free_lengths() const = 0;
    virtual std::uint32_t bin_width() const = 0;
    // Of each; none where all are alike.
    virtual std::span<const std::uint32_t> bin_widths() const { return {}; }
    // The rank-th free y of the place, counted from below, at this offset from its low x.
    virtual Sample at(std::uint32_t place, std::uint32_t rank, std::uint32_t offset) const = 0;

    // Whether no sample so far covers the candidate.
    virtual bool is_free(Sample candidate) const = 0;
    virtual void add(Sample sample) = 0;
    // Where add() leaves the places as they are: cuts or refines them once the round is over.
    virtual void end_round(std::span<const Sample> samples, const RoundPolicy& policy);
};

std::unique_ptr<FreeSpace> make_lines(const Plan& plan);
std::unique_ptr<FreeSpace> make_exact(const Plan& plan);
std::unique_ptr<FreeSpace> make_cells(const Plan& plan);
std::unique_ptr<FreeSpace> make_exact_with_field(const Plan& plan);

}  // namespace lacuna::reference

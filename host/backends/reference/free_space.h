// What the loop of reference.cpp needs of a mode: the free space, and how a sample is cut from it.
// Each mode has a file: lines.cpp, exact.cpp, cells.cpp.
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

    // The free length of each bin: a line or a box.
    virtual std::span<const std::uint32_t> free_lengths() const = 0;
    virtual std::uint32_t bin_width() const = 0;
    // The width of each bin; empty where all are bin_width() wide.
    virtual std::span<const std::uint32_t> bin_widths() const { return {}; }
    // The rank-th free y of the bin, counted from below, and the x at this offset from its low
    // edge.
    virtual Sample at(std::uint32_t bin, std::uint32_t rank, std::uint32_t offset) const = 0;

    // Whether no sample covers the candidate.
    virtual bool is_free(Sample candidate) const = 0;
    virtual void add(Sample sample) = 0;
    // For modes where add() does not cut the bins: cuts or refines them at the end of the round.
    virtual void end_round(std::span<const Sample> samples, const RoundPolicy& policy);
};

std::unique_ptr<FreeSpace> make_lines(const Plan& plan);
std::unique_ptr<FreeSpace> make_exact(const Plan& plan);
std::unique_ptr<FreeSpace> make_cells(const Plan& plan);

}  // namespace lacuna::reference

// What a round is made of: draws become candidates, and candidates become samples (docs/design.md,
// section 3).
#pragma once

#include <lacuna/run.h>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plan/plan.h"

namespace lacuna {

// One inversion of the cdf. Its bin is a line; after the first refinement, and from the start with
// a radius field, it is an active box.
struct Draw {
    std::uint32_t bin;
    std::uint32_t rank;    // along the bin's free length
    std::uint32_t offset;  // in x, from the bin's low edge
    std::uint32_t order;
    friend bool operator==(const Draw&, const Draw&) = default;
};

// A draw turned into a point.
struct Candidate {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t home;  // the line whose strip it lies in; with a radius field the block
                         // (plan/first_boxes.h), which snapshots leave out: they have 0
    std::uint32_t order;
    friend bool operator==(const Candidate&, const Candidate&) = default;
};

// The result of a round. Valid until the backend's next call. `Placed` is a sample: of the plane,
// or in space (space/portion.h).
template <typename Placed>
struct RoundOf {
    std::span<const Placed> samples;                 // admitted, in the order of their draws
    std::uint64_t survivors;                         // draws not covered in earlier rounds
    std::span<const std::uint32_t> free_lengths;     // of every bin, after the round
    std::uint32_t bin_width;                         // of all bins, where bin_widths is empty
    std::span<const std::uint32_t> bin_widths = {};  // of each bin
    std::span<const std::uint32_t> orders = {};      // of the samples' draws, with tells_orders
    // In lines and exact without a radius field: each column's first bin, then the number of bins.
    std::span<const std::uint32_t> bin_begins = {};
    // With classes: the number of bins up to the end of each copy (plan/class_copies.h).
    std::span<const std::uint32_t> copy_ends = {};
};
using Round = RoundOf<Sample>;

// A function that takes the samples of a round, in order of admission.
template <typename Placed>
using TakeSamplesOf = std::function<void(std::span<const Placed>)>;
using TakeSamples = TakeSamplesOf<Sample>;

// The result of all rounds of a plan.
template <typename Placed>
struct OutcomeOf {
    std::uint64_t count = 0;      // of samples
    bool is_cut = false;          // there may be room: the run ended at a limit
    std::vector<Placed> samples;  // in order of admission; none where TakeSamplesOf took them
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    Work work{};
    std::vector<std::uint64_t> numbers;  // of each sample's draw; the reference alone fills them in
};
using Outcome = OutcomeOf<Sample>;

}  // namespace lacuna

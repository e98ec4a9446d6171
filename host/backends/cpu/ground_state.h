// What the cpu backend keeps in mode exact on a ground: rectangles, region by region, and for each
// block of first places the samples that reach it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/cpu/near_lists.h"
#include "backends/cpu/state.h"
#include "plan/ground.h"
#include "plan/pixels.h"

namespace lacuna::cpu {

// A region (plan/first_places.h) stands where other modes have a column. A candidate's line is the
// block that it lies in.
struct GroundState : State {
    explicit GroundState(const Plan& plan);

    // With the block that it is a part of.
    struct Place {
        Rectangle at;
        std::uint32_t block;
    };

    const Ground& ground;
    const FirstPlaces& first;
    std::vector<std::vector<Place>> places;  // of each region, those of a block together
    NearLists near;

    void end_locate() { is_screened = true; }
    // From now on these are the places: then to be called for each region, in parallel.
    void settle_places();
    void settle_places(std::uint32_t region);
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);
};

void set_free(GroundState& state, std::uint32_t region);
void locate(GroundState& state, std::span<const Draw> draws, std::uint32_t region);
void screen(GroundState& state, std::uint32_t region);

// Replaces the region's places by what all samples near them leave of them, or with `halve` of two
// halves of each, and of parts where pixels differ.
void refine(GroundState& state, std::uint32_t region, bool halve);

}  // namespace lacuna::cpu

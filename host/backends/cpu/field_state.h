// What the cpu backend keeps in mode exact with a radius field: rectangles, region by region, and
// for each block of first boxes the samples that reach it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/cpu/neighbour_lists.h"
#include "backends/cpu/state.h"
#include "plan/pixels.h"
#include "plan/radius_field.h"

namespace lacuna::cpu {

// A region (plan/first_boxes.h) stands where other modes have a column. A candidate's line is the
// block that it lies in.
struct FieldState : State {
    explicit FieldState(const Plan& plan);

    // With the block that it is a part of.
    struct Place {
        Rectangle at;
        std::uint32_t block;
    };

    const RadiusField& radius_field;
    const FirstBoxes& first;
    std::vector<std::vector<Place>> places;  // of each region, those of a block together
    NeighbourLists near;

    void end_locate() { is_screened = true; }
    // From now on these are the places: then to be called for each region, in parallel.
    void settle_places();
    void settle_places(std::uint32_t region);
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);
};

void set_free(FieldState& state, std::uint32_t region);
void locate(FieldState& state, std::span<const Draw> draws, std::uint32_t region);
void screen(FieldState& state, std::uint32_t region);

// Replaces the region's places by what all samples near them leave of them, or with `halve` of two
// halves of each, and of parts where pixels differ.
void refine(FieldState& state, std::uint32_t region, bool halve);

}  // namespace lacuna::cpu

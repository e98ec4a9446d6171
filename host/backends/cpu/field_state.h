// The cpu backend's memory in mode exact with a radius field: the active boxes of each region, and
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

// Regions (plan/first_boxes.h) stand for columns here. Candidate::line holds the block that the
// candidate lies in.
struct FieldState : State {
    explicit FieldState(const Plan& plan);

    // An active box, and the block that it is a part of.
    struct BlockBox {
        Box at;
        std::uint32_t block;
    };

    const RadiusField& radius_field;
    const FirstBoxes& first;
    std::vector<std::vector<BlockBox>> boxes;  // active boxes of each region, block by block
    NeighbourLists near;

    // Makes the active boxes the bins. Call it once, then for each region, in parallel.
    void measure_boxes();
    void measure_boxes(std::uint32_t region);
    // Puts restored samples of the round into the lists.
    void insert_admitted();
    Snapshot snapshot(Stage stage) const;
    void restore(const Snapshot& snapshot);

private:
    std::uint32_t region_of(std::uint32_t block) const;
};

void set_free(FieldState& state, std::uint32_t region);
void locate(FieldState& state, std::span<const Draw> draws, std::uint32_t region);
void screen(FieldState& state, std::uint32_t region);

// Replaces the region's boxes by the pieces that the samples near them leave. With `halve` each box
// is halved first, along borders of pixels where it lies on unlike pixels.
void refine(FieldState& state, std::uint32_t region, bool halve);

}  // namespace lacuna::cpu

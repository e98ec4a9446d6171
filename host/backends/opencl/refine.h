// refine: what all samples leave of the places, in boxes.
#pragma once

#include "backends/opencl/state.h"

namespace lacuna::opencl {

// Puts the round's samples into their cells, once admission is settled.
void queue_insert(State& state);

// The round's samples go into their cells, and the places become boxes, cut by all samples near
// them; with `halve`, into two of half the width. Admission must be settled.
void refine(State& state, bool halve);

}  // namespace lacuna::opencl

// The importance field of figures 6 and 8: dense shapes on a sparse background.
#pragma once

#include <lacuna/lacuna.h>

namespace lacuna::reproduce {

// On the unit square: a disk, four bars, the thinner the farther right, and a ramp. Disk and bars
// have importance 1, the ramp goes from `background` to 1, and all else has `background`.
Field shapes(double background);

}  // namespace lacuna::reproduce

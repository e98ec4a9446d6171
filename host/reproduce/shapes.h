// The importance field of figures 6 and 8: dense shapes on a sparse background.
#pragma once

#include <lacuna/lacuna.h>

namespace lacuna::reproduce {

// On the unit square: a disk, four bars that grow thinner to the right and a ramp, of importance 1
// (the ramp from `background` to 1), on a background of importance `background`.
Field shapes(double background);

}  // namespace lacuna::reproduce

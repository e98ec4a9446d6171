// The importance field of figures 6 and 8: dense shapes on a sparse ground.
#pragma once

#include <lacuna/lacuna.h>

namespace lacuna::reproduce {

// On the unit square: a disk, four bars that grow thinner to the right and a ramp, of importance 1
// (the ramp from `ground` to 1), on a ground of importance `ground`.
Field shapes(double ground);

}  // namespace lacuna::reproduce

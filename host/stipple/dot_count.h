// The number of dots that suits a picture, on a screen or drawn by a pen.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>

#include "drawing/picture.h"
#include "stipple/dot_size.h"

namespace lacuna::stippling {

// The mean importance, from 0 to 1.
double darkness_of(const Field& field);

// One dot for 16 pixels of black, from 1 to kMostDots. A grey pixel counts by its darkness, and the
// longer side counts as 512 to 2048 pixels. The domain's longer side is 1.
constexpr double kMostDots = 1e6;
std::uint64_t dot_count(const Field& field, const Domain& domain);

// The number of dots that pens draw at which they cover as much of the page as the picture is dark.
double dots_for_ink(const Field& field, const Domain& domain, const Sizing& sizing,
                    const drawing::Style& style);

// The number of dots if the user gives none: with pens dots_for_ink(), from 1 to kMostDots, and
// without them dot_count().
std::uint64_t default_count(const Field& field, const Domain& domain, const Sizing& sizing,
                            const drawing::Style& style);

}  // namespace lacuna::stippling

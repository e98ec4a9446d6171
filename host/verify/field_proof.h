// Proves or refutes what a set promises whose radii follow a field.
#pragma once

#include <lacuna/verify.h>

#include <span>

#include "verify/patience.h"

namespace lacuna::verify {

// Twice verify's own: borders of pixels are rounded to the grid too, by up to two units each way.
double default_field_tolerance(double width, double height);

// claim.field is not null. Throws as prove does.
Proof prove_field(std::span<const Point> points, const Claim& claim, const Patience& patience);

}  // namespace lacuna::verify

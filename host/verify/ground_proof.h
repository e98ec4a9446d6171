// Proves or refutes what a set promises that follows a field, or that does not fill its domain.
#pragma once

#include <lacuna/verify.h>

#include <cstddef>
#include <optional>
#include <span>

#include "verify/patience.h"

namespace lacuna::verify {

// Twice verify's own: borders of pixels are rounded to the grid too, by up to two units each way.
double default_ground_tolerance(double width, double height);

// The first point of `kept` that is not at its own place among `points`.
std::optional<std::size_t> first_moved(std::span<const Point> points, std::span<const Point> kept);

// Throws as prove does. Knows nothing of claim.keep.
Proof prove_on_ground(std::span<const Point> points, const Claim& claim, const Patience& patience);

}  // namespace lacuna::verify

// Which claims about a point set make sense, and what a tolerance may be.
//
// The proofs share no code with the samplers and do not know their whole numbers: everything is
// computed in doubles from what the user reads back, with bounds for the rounding of doubles.
#pragma once

#include <lacuna/verify.h>

#include <cstddef>
#include <string>
#include <vector>

#include "verify/radius_field.h"

namespace lacuna::verify {

// The largest tolerance, as a share of the radius, with which a set is proven maximal. A gap that
// is wider by more is no effect of rounding: a point taken out of a maximal set leaves a place that
// is at least one radius from every other point, on average 1.054 radii. So with a tolerance of
// some 5 % a set with holes would pass for maximal.
inline constexpr double kMostTolerance = 0.01;

// The smallest radius, as a share of the longer side. It is far larger than what doubles can tell
// apart, and far smaller than the radius of any set that fits into a computer.
inline constexpr double kSmallestProvenRadius = 0x1p-32;

// Throws BadRequest for a domain, field, scale, radius, tolerance, mask, polygons, border or
// classes that make no sense.
void check_claim(const Claim& claim, std::size_t points, double tolerance);

// Throws BadRequest if the smallest radius that the claim asks for is below kSmallestProvenRadius.
void check_least_radius(const Claim& claim, double least_radius);

// Throws BadRequest if an ellipse is longer than the shorter side of a torus. There two points have
// several ways between them, and more than one might lie in the ellipse.
void check_longest_ellipse(const Claim& claim, double longest_radius);

// Whether the claim has one radius, and lets points lie everywhere.
bool is_uniform(const Claim& claim);

// The claim's tolerance, or if it has none, more than samplers on a grid may lose. For a uniform
// claim that is 2^-28 of the longer side: at least four units of a grid with 2^30 or more units
// along that side. Rounding the radius up takes up to two units. A spot between the lines of the
// grid is up to sqrt(2) units from a point of the grid. Other claims have twice this tolerance,
// because borders of pixels are rounded to the grid, too, by up to two units. With classes the
// least distance is rounded, and others are multiples of it. With more than four classes, or eight,
// the grid has half as many units, or a quarter.
double tolerance_of(const Claim& claim);

}  // namespace lacuna::verify

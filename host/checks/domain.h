// A domain: the limits of its sides and its corner, what the corner's rounding loses, and texts for
// messages.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

// How far the corner may lie from 0 along an axis, in longer sides. Within that, two neighbouring
// doubles are at most 2^-32 of the longer side apart, which is half of the finest grid's unit: no
// sample is rounded to the upper edges.
inline constexpr double kFarthestCorner = 0x1p20;

// Throws BadRequest unless both sides lie between 1e-100 and 1e100, neither is over 1000 times the
// other, and the corner is finite and not farther away.
void check_domain(const Domain& domain);

// Checks a border, which a message shows as `value`: finite, at least 0, and 0 on a torus. Throws
// BadRequest.
void check_border(const Domain& domain, double border, const std::string& value);

// The most that the distance of two samples loses when the corner is added to both and the sums are
// rounded to doubles. 0 if the corner is (0, 0).
double lost_at_corner(const Domain& domain);

// The ways from the corner to points of the domain.
std::vector<Point> from_corner(std::span<const Point> points, const Domain& domain);

// The domain as the option has it: 2x1, or 10,20+2x1 if its corner is not (0, 0).
std::string text_of(const Domain& domain);
// Columns and rows as the option has them: 512x80.
std::string text_of(const Raster& raster);
// " at (10, 20)", to be written behind the sides; empty if the corner is (0, 0).
std::string corner_text(double x0, double y0);
// Its extent as intervals, with `end` behind the upper edges: [0, 2) x [0, 1).
std::string extent_of(const Domain& domain, char end);

}  // namespace lacuna

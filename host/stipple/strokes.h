// The strokes of a pen, made of ellipses: 2 a long with their round ends, and 2 b wide.
#pragma once

#include <lacuna/lacuna.h>

#include <span>

namespace lacuna::stippling {

// Makes strokes of ellipses, each as wide as the pen and as long as the root of its ratio of radii,
// so that the areas of all sum to `ink`.
void make_strokes(std::span<Ellipse> ellipses, double ink, double pen);

// Cuts strokes where the line between the middles of their round ends leaves the domain, which
// moves their middles. Returns whether there were any.
bool cut_strokes(std::span<Point> middles, std::span<Ellipse> strokes, const Domain& domain);

// Turns strokes so that the pen goes from the end of each to the nearer end of the next one.
void turn_strokes(std::span<const Point> middles, std::span<Ellipse> strokes);

// Where the pen comes down, for `sign` -1, or is lifted, for 1: the middle of the round end.
Point end_of(Point middle, const Ellipse& stroke, double sign);

}  // namespace lacuna::stippling

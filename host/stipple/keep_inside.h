// Keeps dots off the white parts of a picture.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>
#include <span>
#include <vector>

namespace lacuna::stippling {

// The parts of a picture in which no ink is wanted: pixels of importance 0. What
// lies outside of the picture is white, too, except on a torus.
struct White {
    const Field& field;
    Domain domain;

    // The point of white that is nearest to `from`, if one is nearer than `reach`. On a torus it
    // may lie outside of the picture, beside `from`.
    std::optional<Point> nearest(Point from, double reach) const;
};

// For each pixel the width of the ink there, at most `most`: the diameter of the largest disk off
// white around a pixel's middle that reaches this pixel's middle. 0 on white.
std::vector<double> widths_of(const White& white, double most);

// Moves dots away from white until none touches it, each as far as its dot overhangs. Where a shape
// is narrower than a dot, the dot comes near the middle of it. A dot stops before it comes nearer
// to another one than Crowd::kApart of their mean diameter. Points that lie on white stay.
void pull_inside(std::span<Point> points, std::span<const double> diameters, const White& white);

// Makes dots that still overhang smaller until they do not, but not smaller than `least`.
void fit_inside(std::span<const Point> points, std::span<double> diameters, const White& white,
                double least = 0);

}  // namespace lacuna::stippling

// The sizes of the dots of a stippled picture.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/stipple.h>

#include <optional>
#include <span>
#include <vector>

namespace lacuna::stippling {

// How dots are spread: like darts thrown at random, or evenly, as relax leaves them.
enum class Spread { random, even };

// How a tone is shown: by how densely dots lie, and by how large they are. A dot's area follows the
// importance of its pixel; dots are as dense as importance over area, so that the ink is the same.
struct Sizing {
    // Areas are proportional to importance to this power, 0 to 1. 0: all dots are equally large.
    double by_tone = 0;
    // Or the diameters of pens, in proportion to importance.
    std::optional<Pens> pens{};
    // Where the importance is 1, dots of the library's choice are so wide that they leave no gaps.
    bool solid_black = false;
    // Or a line is drawn through all dots: its length near a dot grows with the root of their
    // density, so dots lie as densely as importance squared.
    bool is_line = false;
    // How dots lie, which decides how much they overlap.
    Spread spread = Spread::even;
    // Whether pens draw more dots where they overlap, as other dots are wider there. Not for sets
    // that keep distances, which follow importance alone.
    bool fills_overlaps = false;
    // Or dots are strokes of a pen along the field's stretches, as long as the root of their ratio.
    bool are_strokes = false;

    // Of each pixel, or empty: how large a dot's area is there, as a share of what it is elsewhere.
    // Dots are as much denser there.
    std::span<const double> shares{};

    bool varies() const;
    // How many layers of ink a line or strokes need for an importance: more than it, because they
    // lie on themselves. Dots are wider instead.
    double layers_at(double importance) const;
    // The area of a dot: relative, or in mm^2 with pens; with fills_overlaps without what other
    // dots cover of it.
    double area_at(double importance) const;
};

// The diameter, in mm, of a dot that pens draw where the importance is this.
double width_at(const Pens& pens, double importance);

// The importance of the pixel in which a point of the domain lies.
double importance_at(Point point, const Field& field, const Domain& domain);

// How densely dots lie: importance over area. For dots of one size it is proportional to the field.
Field density_of(const Field& field, const Sizing& sizing);

// The diameter of each point's dot, in the domain's units. The ink then covers the fraction of the
// paper that the importance says: half where it is 0.5, and 99 % where it is 1. As long as few dots
// overlap, the areas of all dots sum to the integral of the importance. Above importance 0.55 more
// dots overlap, so they are up to 1.3 times as wide (1.12 times for Spread::even). Dots of
// Spread::random are then, without solid_black, all made wider or narrower by one factor: that of
// 0.8 to 1.25 at which together they cover the mean importance best. `points` fill the domain, and
// `field` is stretched over it. `sizing` has no pens.
std::vector<double> dot_diameters(std::span<const Point> points, const Field& field,
                                  const Domain& domain, Spread spread = Spread::random,
                                  const Sizing& sizing = {});

// The diameters, in the domain's units, of dots that pens draw.
std::vector<double> pen_diameters(std::span<const Point> points, const Field& field,
                                  const Domain& domain, const Pens& pens,
                                  double millimetres_per_unit);

}  // namespace lacuna::stippling

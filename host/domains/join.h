// Joins the polygons of a drawing, each with a fill rule of its own, to one set of rings.
#pragma once

#include <lacuna/lacuna.h>

#include <vector>

namespace lacuna::domains {

// What tells whether a place is inside of a polygon: that an odd number of rings goes around it, or
// that its rings go around it another number of times in one direction than in the other.
enum class Fill { even_odd, nonzero };

struct Polygon {
    std::vector<PolygonRing> rings;
    Fill fill = Fill::even_odd;
};

// Rings of the same inside by the even-odd rule, as all code after the readers takes them: no ring
// runs where two polygons overlap or touch. A single polygon of the even-odd rule is not changed;
// otherwise coordinates are rounded to 2^-51 of the largest, and the order of rings changes.
std::vector<PolygonRing> join(std::vector<Polygon> polygons);

}  // namespace lacuna::domains

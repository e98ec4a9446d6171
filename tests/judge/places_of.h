// Sets of polygons as places, for claims.
#pragma once

#include <lacuna/places.h>

#include <span>
#include <vector>

namespace lacuna::tests {

inline Places places_of(std::span<const PolygonSet> sets, double edge) {
    Places places{.edge = edge};
    for (const PolygonSet& set : sets)
        places.outlines.push_back({.polygons = {{set.rings.begin(), set.rings.end()}, {}},
                                   .role = set.role,
                                   .distance = set.distance});
    return places;
}

inline Places places_of(std::vector<PolygonRing> rings, double edge = 0) {
    return {.outlines = {{.polygons = {std::move(rings), {}}, .distance = 0}}, .edge = edge};
}

}  // namespace lacuna::tests

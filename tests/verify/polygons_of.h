// One set of polygons for a claim.
#pragma once

#include <lacuna/lacuna.h>

#include <deque>
#include <span>
#include <vector>

namespace lacuna {

// The set of these rings, which must outlive the claim. The set lives as long as the program.
inline std::span<const PolygonSet> polygons_of(const std::vector<PolygonRing>& rings) {
    static std::deque<PolygonSet> sets;
    sets.push_back({rings});
    return {&sets.back(), 1};
}

}  // namespace lacuna

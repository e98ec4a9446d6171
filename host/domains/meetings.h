// How rings lie to each other: which ones have outlines that meet, and which ones lie in others.
#pragma once

#include <lacuna/domain.h>

#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace lacuna::domains {

// Pairs of rings, the lower number first.
using RingPairs = std::set<std::pair<std::size_t, std::size_t>>;

// The pairs of rings whose outlines cross or touch. May include pairs that are apart by rounding.
RingPairs meetings(std::span<const PolygonRing> rings);

// For each ring the others that go around its first point an odd number of times. Where two
// outlines meet at that point, rounding decides.
std::vector<std::vector<std::size_t>> rings_around(std::span<const PolygonRing> rings);

}  // namespace lacuna::domains

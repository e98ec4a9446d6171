// Distances between points: to the nearest, and between all near pairs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/neighbours.h"

namespace lacuna::analysis {

// Curves over distance are in units of the mean spacing, sqrt(area / count): sets of any count and
// domain compare. A square lattice has its nearest neighbours at 1, a hexagonal one at 1.0746.
double mean_spacing(const Domain& domain, std::size_t count);

// Of each point, in the domain's unit: the distance to the nearest other point. At least two
// points. On a box, points near its edge have fewer others around them: nothing is done about that.
std::vector<double> nearest_distances(const Neighbours& neighbours);

// The least distance over the largest that so many points can have, that of the hexagonal lattice,
// sqrt(2 / (sqrt(3) * count / area)) (Lagae & Dutre 2008, section 4): 0 to 1 on a large torus,
// about 0.77 for maximal Poisson-disk sets.
double relative_radius(double least_distance, const Domain& domain, std::size_t count);

// The pair correlation g: the density of pairs at a distance over that of as many independent
// points. The entry i is the mean of g over [i, i + 1) * kPairBin mean spacings. Without bias on
// the torus and, as the area that a shifted domain shares with itself is accounted for, on the box.
constexpr double kPairBin = 0.005;
constexpr double kPairReach = 10;  // or half the domain's shorter side, if that is less

// At least two points.
std::vector<double> pair_correlation(const Neighbours& neighbours);

// The mean of g over the distances [from, to), in the domain's unit, `to` within half the shorter
// side. At least two points.
double pair_correlation_between(const Neighbours& neighbours, double from, double to);

// The entries of g, each over `bins` of before, the last few left out if they do not fill one.
std::vector<double> coarser(const std::vector<double>& g, std::size_t bins);

}  // namespace lacuna::analysis

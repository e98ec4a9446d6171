// Distances between points: to the nearest point, and between all near pairs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/neighbours.h"

namespace lacuna::analysis {

// The unit of distance of all curves, sqrt(area / count), in which sets of any count and domain can
// be compared. Nearest neighbours are 1 apart in a square lattice and 1.0746 in a hexagonal one.
double mean_spacing(const Domain& domain, std::size_t count);

// The distance from each point to the nearest other point, in the domain's unit. Needs at least two
// points. On a box, points near an edge have fewer neighbours; this is not corrected.
std::vector<double> nearest_distances(const Neighbours& neighbours);

// The least distance divided by the largest possible one for this number of points, which the
// hexagonal lattice has: sqrt(2 / (sqrt(3) * count / area)) (Lagae & Dutre 2008, section 4). It is
// 0 to 1 on a large torus, and about 0.77 for maximal Poisson-disk sets.
double relative_radius(double least_distance, const Domain& domain, std::size_t count);

// The pair correlation g: the density of pairs at a distance, divided by the density for as many
// independent points. Entry i is the mean of g over [i, i + 1) * kPairBin mean spacings. It is
// unbiased on the torus, and on the box, too, where the effect of the edges is divided out.
constexpr double kPairBin = 0.005;
constexpr double kPairReach = 10;  // or half the domain's shorter side, if less

// Needs at least two points.
std::vector<double> pair_correlation(const Neighbours& neighbours);

// The mean of g over the distances [from, to) in the domain's unit; `to` is at most half the
// shorter side. Needs at least two points.
double pair_correlation_between(const Neighbours& neighbours, double from, double to);

// g in wider bins: each is the mean of `bins` entries. Entries that fill no bin are dropped.
std::vector<double> coarser(const std::vector<double>& g, std::size_t bins);

}  // namespace lacuna::analysis

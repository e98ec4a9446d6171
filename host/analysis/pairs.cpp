// Divides counts of pairs by the counts that independent points would have.
#include "analysis/pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lacuna::analysis {
namespace {

// The fraction of pairs of independent points that are closer than `distance`, which is at most
// half the shorter side. On a box: the overlap of the domain with itself shifted by t is, on
// average over all directions,
//   width * height - (2 / pi) (width + height) t + t^2 / pi
// (its isotropized set covariance, Stoyan & Stoyan 1994). This is multiplied by 2 pi t, integrated,
// and divided by the squared area. Lengths are divided by the sides first, so that nothing
// overflows.
double share_closer_than(double distance, const Domain& domain) {
    const double u = distance / domain.width;
    const double v = distance / domain.height;
    const double disk = std::numbers::pi * u * v;
    return domain.torus ? disk : disk - 4.0 / 3.0 * u * v * (u + v) + u * u * v * v / 2;
}

double all_pairs(const Neighbours& neighbours) {
    const auto count = static_cast<double>(neighbours.points().size());
    return count * (count - 1) / 2;
}

}  // namespace

double mean_spacing(const Domain& domain, std::size_t count) {
    return std::sqrt(domain.width * domain.height / static_cast<double>(count));
}

std::vector<double> nearest_distances(const Neighbours& neighbours) {
    std::vector<double> distances(neighbours.points().size());
    neighbours.for_each_point(
        [&](std::size_t i) { distances[i] = neighbours.nearest(i, 1).front().distance; });
    return distances;
}

double relative_radius(double least_distance, const Domain& domain, std::size_t count) {
    return least_distance / (mean_spacing(domain, count) * std::sqrt(2 / std::sqrt(3.0)));
}

std::vector<double> pair_correlation(const Neighbours& neighbours) {
    const Domain& domain = neighbours.domain();
    const double width = kPairBin * mean_spacing(domain, neighbours.points().size());
    const double half = std::min(domain.width, domain.height) / 2;
    const auto bins = static_cast<std::size_t>(std::min(kPairReach / kPairBin, half / width));
    if (bins == 0) return {};
    const std::vector<std::uint64_t> counts = neighbours.count_pairs(width, bins);
    std::vector<double> g(bins);
    for (std::size_t i = 0; i < bins; ++i) {
        const double begin = width * static_cast<double>(i);
        const double expected = all_pairs(neighbours) * (share_closer_than(begin + width, domain) -
                                                         share_closer_than(begin, domain));
        g[i] = static_cast<double>(counts[i]) / expected;
    }
    return g;
}

double pair_correlation_between(const Neighbours& neighbours, double from, double to) {
    const Domain& domain = neighbours.domain();
    const auto pairs = static_cast<double>(neighbours.pairs_closer_than(to)) -
                       static_cast<double>(neighbours.pairs_closer_than(from));
    return pairs / (all_pairs(neighbours) *
                    (share_closer_than(to, domain) - share_closer_than(from, domain)));
}

std::vector<double> coarser(const std::vector<double>& g, std::size_t bins) {
    std::vector<double> means(g.size() / bins);
    for (std::size_t i = 0; i < means.size(); ++i) {
        double sum = 0;
        double weights = 0;
        for (std::size_t j = i * bins; j < (i + 1) * bins; ++j) {
            const double weight = 2 * static_cast<double>(j) + 1;  // as the ring's area
            sum += weight * g[j];
            weights += weight;
        }
        means[i] = sum / weights;
    }
    return means;
}

}  // namespace lacuna::analysis

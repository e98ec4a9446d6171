// Computes single numbers from radial power, pair correlation and nearest neighbours.
#include "analysis/order.h"

#include <math.h>  // j0, which POSIX has and C++ has not
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "analysis/pairs.h"

namespace lacuna::analysis {
namespace {

// For each annulus, the mean power of all frequencies below its outer edge.
std::vector<double> disk_means(const Radial& radial) {
    std::vector<double> means;
    double sum = 0;
    double modes = 0;
    for (const Annulus& annulus : radial.annuli) {
        sum += annulus.power * static_cast<double>(annulus.modes);
        modes += static_cast<double>(annulus.modes);
        means.push_back(sum / modes);
    }
    return means;
}

// Blackman's window: falls from 1 at 0 to 0 at 1.
double blackman(double x) {
    const double angle = std::numbers::pi * x;
    return 0.42 + 0.5 * std::cos(angle) + 0.08 * std::cos(2 * angle);
}

using Psi = std::complex<double>;

// Empty if one of the six nearest neighbours could lie beyond the edge of a box.
std::optional<Psi> psi_6(const Neighbours& neighbours, std::size_t index) {
    constexpr std::size_t kBonds = 6;
    const auto nearest = neighbours.nearest(index, kBonds);
    const Domain& domain = neighbours.domain();
    const Point at = neighbours.points()[index];
    const double to_edge = std::min({at.x, at.y, domain.width - at.x, domain.height - at.y});
    if (!domain.torus && nearest.back().distance > to_edge) return std::nullopt;
    Psi sum = 0;
    for (const auto& neighbour : nearest)
        sum += std::polar(1.0, double{kBonds} * std::atan2(neighbour.dy, neighbour.dx));
    return sum / double{kBonds};
}

}  // namespace

std::optional<double> effective_nyquist(const Radial& radial) {
    constexpr double kQuiet = 0.1;
    constexpr double kLoud = 0.5;
    const std::vector<double> means = disk_means(radial);
    const auto& annuli = radial.annuli;
    std::size_t i = 0;
    while (i < means.size() && (annuli[i].outer < 0.5 || means[i] <= kLoud)) ++i;
    if (i == means.size()) return std::nullopt;
    while (means[i] >= kQuiet) {
        if (i == 0) return 0;
        --i;
    }
    const double share = (kQuiet - means[i]) / (means[i + 1] - means[i]);
    return annuli[i].outer + share * (annuli[i + 1].outer - annuli[i].outer);
}

double power_from_pairs(const std::vector<double>& g, double f) {
    double sum = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
        const double x = (static_cast<double>(i) + 0.5) * kPairBin;
        const double window = blackman(x / (static_cast<double>(g.size()) * kPairBin));
        sum += (g[i] - 1) * ::j0(2 * std::numbers::pi * f * x) * window * x;
    }
    return 1 + 2 * std::numbers::pi * kPairBin * sum;
}

std::optional<double> oscillations(const std::vector<double>& g) {
    constexpr double kNearOne = 0.98;
    constexpr double kStep = 0.02;
    constexpr int kStepsOfRing = 250;  // ten times sqrt(count) / 2
    constexpr int kFarthestStart = 150;
    if (static_cast<double>(g.size()) * kPairBin < kLeastReach) return std::nullopt;
    int start = 0;
    while (power_from_pairs(g, start * kStep) < kNearOne)
        if (++start > kFarthestStart) return std::nullopt;
    std::vector<double> weighted(kStepsOfRing + 1);
    tbb::parallel_for(0, kStepsOfRing + 1, [&](int step) {
        const double f = (start + step) * kStep;
        const double excess = power_from_pairs(g, f) - 1;
        const double end = step == 0 || step == kStepsOfRing ? 0.5 : 1;  // trapezium rule
        weighted[static_cast<std::size_t>(step)] = end * excess * excess * f;
    });
    double sum = 0;
    for (const double value : weighted) sum += value;
    const double from = start * kStep;
    const double to = (start + kStepsOfRing) * kStep;
    return 10 * std::sqrt(2 * sum * kStep / (to * to - from * from));
}

std::optional<BondOrder> bond_order(const Neighbours& neighbours) {
    constexpr std::size_t kLeastPoints = 7;
    const std::size_t count = neighbours.points().size();
    if (count < kLeastPoints) return std::nullopt;
    std::vector<std::optional<Psi>> all(count);
    neighbours.for_each_point([&](std::size_t i) { all[i] = psi_6(neighbours, i); });
    Psi sum = 0;
    double magnitudes = 0;
    std::size_t points = 0;
    for (const std::optional<Psi>& psi : all) {
        if (!psi) continue;
        sum += *psi;
        magnitudes += std::abs(*psi);
        ++points;
    }
    if (points == 0) return std::nullopt;
    const auto divisor = static_cast<double>(points);
    return BondOrder{std::abs(sum) / divisor, magnitudes / divisor, points};
}

}  // namespace lacuna::analysis

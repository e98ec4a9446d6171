// The public functions for analysis.
#include <fmt/core.h>
#include <lacuna/analysis.h>

#include <algorithm>
#include <string>

#include "analysis/analyse.h"
#include "base/polling.h"
#include "checks/domain.h"
#include "verify/domain.h"

namespace lacuna {
namespace {

void check(std::span<const std::vector<Point>> sets, const Domain& domain) {
    check_domain(domain);
    if (sets.empty()) throw BadRequest("sets", "none", "there must be at least one");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].empty())
            throw BadRequest("sets", std::to_string(i), "must have at least one point");
        // As in analyse(), points may lie on the upper edges, on a torus too.
        const verify::Domain with_edges{domain.width, domain.height, false, domain.x0, domain.y0};
        const auto is_inside = [&](Point p) { return with_edges.contains(p); };
        const auto out = std::find_if_not(sets[i].begin(), sets[i].end(), is_inside);
        if (out != sets[i].end())
            throw BadRequest(
                "sets",
                fmt::format("point {}{} at ({}, {})", out - sets[i].begin(),
                            sets.size() == 1 ? "" : fmt::format(" of set {}", i), out->x, out->y),
                "must lie in the domain, " + extent_of(domain, ']'));
    }
}

}  // namespace

Statistics analyze(std::span<const std::vector<Point>> sets, const Domain& domain,
                   const std::function<bool(double share)>& keep_going, double max_frequency,
                   std::uint32_t threads) {
    check(sets, domain);
    const analysis::Analysis found = analysis::analyse(sets, verify::domain_of(domain), {},
                                                       [&](double share) {
                                                           ask();
                                                           return !keep_going || keep_going(share);
                                                       },
                                                       {max_frequency, threads});
    Statistics statistics;
    statistics.mean_count = found.counts.mean;
    if (found.distances) {
        statistics.least_distance = found.distances->least;
        statistics.mean_distance = found.distances->mean;
        statistics.relative_radius = found.distances->relative_radius;
        statistics.pair_correlation = found.distances->pair_correlation;
    }
    for (const analysis::Annulus& annulus : found.radial.annuli)
        statistics.rings.push_back({annulus.frequency, annulus.power, annulus.anisotropy_db});
    statistics.effective_nyquist = found.effective_nyquist;
    statistics.oscillations = found.oscillations;
    if (found.bond_order) statistics.psi_6 = found.bond_order->local;
    return statistics;
}

}  // namespace lacuna

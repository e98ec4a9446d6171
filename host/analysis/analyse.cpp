// Analyses one set after the other, then takes the means.
#include "analysis/analyse.h"

#include <fmt/core.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/neighbours.h"
#include "analysis/pairs.h"
#include "base/threads.h"
#include "checks/domain.h"
#include "checks/numbers.h"

namespace lacuna::analysis {
namespace {

Counts counts_of(std::span<const std::vector<Point>> sets) {
    Counts counts{sets.front().size(), 0, 0};
    for (const auto& points : sets) {
        counts.least = std::min(counts.least, points.size());
        counts.most = std::max(counts.most, points.size());
        counts.mean += static_cast<double>(points.size()) / static_cast<double>(sets.size());
    }
    return counts;
}

// Adds `values` to `sums`. `sums` is cut to the shortest length, so every entry is over all sets.
void accumulate(std::vector<double>& sums, const std::vector<double>& values, bool is_first) {
    if (is_first) {
        sums = values;
        return;
    }
    sums.resize(std::min(sums.size(), values.size()));
    std::transform(sums.begin(), sums.end(), values.begin(), sums.begin(), std::plus<>());
}

// Sums over the sets.
class Distributions {
public:
    Distributions(const Domain& domain, std::size_t sets)
        : domain_(domain), share_(1.0 / static_cast<double>(sets)) {}

    void add(const Neighbours& neighbours, std::optional<double> radius) {
        add_nearest(nearest_distances(neighbours));
        accumulate(g_, pair_correlation(neighbours), is_first_);
        add_contact(neighbours, radius.value_or(0));
        is_first_ = false;
    }

    // The mean over the sets, in bins of kPairBin.
    std::vector<double> pair_correlation_mean() const {
        std::vector<double> mean = g_;
        for (double& value : mean) value *= share_;
        return mean;
    }

    Distances means() const {
        Distances means = distances_;
        std::vector<double> g = pair_correlation_mean();
        g.resize(std::min(g.size(), kReportedPairBins * kFineBins));
        means.pair_correlation = coarser(g, kFineBins);
        if (has_contact_) means.contact = contact_;
        return means;
    }

private:
    void add_nearest(const std::vector<double>& nearest) {
        const double spacing = mean_spacing(domain_, nearest.size());
        const double point_share = share_ / static_cast<double>(nearest.size());
        distances_.nearest_shares.resize(kNearestBins, 0);
        for (const double distance : nearest) {
            distances_.mean += distance * point_share;
            const double bin = distance / (spacing * kNearestBin);
            if (bin < double{kNearestBins}) {
                distances_.nearest_shares[static_cast<std::size_t>(bin)] += point_share;
            } else {
                distances_.nearest_beyond += point_share;
            }
        }
        const double least = *std::min_element(nearest.begin(), nearest.end());
        const double relative = relative_radius(least, domain_, nearest.size());
        distances_.least = is_first_ ? least : std::min(distances_.least, least);
        distances_.relative_radius =
            is_first_ ? relative : std::min(distances_.relative_radius, relative);
    }

    // Adds the mean of g from the radius `from` on; 0 means that the radius is unknown.
    void add_contact(const Neighbours& neighbours, double from) {
        const double to = kContactEnd * from;
        has_contact_ = has_contact_ && from > 0 && to < std::min(domain_.width, domain_.height) / 2;
        if (!has_contact_) return;
        contact_ += share_ * pair_correlation_between(neighbours, from, to);
    }

    Domain domain_;
    double share_;
    bool is_first_ = true;
    bool has_contact_ = true;
    double contact_ = 0;
    Distances distances_{};
    std::vector<double> g_;
};

// The mean over all sets; empty if it is unknown for one of them.
class BondOrders {
public:
    void add(const std::optional<BondOrder>& order) {
        known_ = known_ && order.has_value();
        if (!known_) return;
        sum_.global += order->global;
        sum_.local += order->local;
        sum_.points += order->points;
        ++sets_;
    }
    std::optional<BondOrder> mean() const {
        if (!known_) return std::nullopt;
        return BondOrder{sum_.global / sets_, sum_.local / sets_, sum_.points};
    }

private:
    bool known_ = true;
    double sets_ = 0;
    BondOrder sum_{};
};

void add_radius(Analysis& analysis, std::span<const std::vector<Point>> sets,
                std::span<const std::optional<double>> radii) {
    const auto is_known = [](const std::optional<double>& radius) { return radius.has_value(); };
    if (radii.empty() || !std::all_of(radii.begin(), radii.end(), is_known)) return;
    const double area = analysis.domain.width * analysis.domain.height;
    double radius = 0;
    double product = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        radius += *radii[i];
        product += static_cast<double>(sets[i].size()) * *radii[i] * *radii[i] / area;
    }
    analysis.radius = radius / static_cast<double>(sets.size());
    analysis.count_times_squared_radius = product / static_cast<double>(sets.size());
}

void add_distances(Analysis& analysis, std::span<const std::vector<Point>> sets,
                   std::span<const std::optional<double>> radii, const KeepGoing& keep_going) {
    BondOrders bond_orders;
    Distributions distributions(analysis.domain, sets.size());
    double done = 0;   // number of sets that are finished
    double polls = 0;  // polls during the current set
    double expected_polls = 1;
    const auto poll = [&] {
        const double part = std::min(1.0, polls++ / expected_polls);
        if (!keep_going((done + part) / static_cast<double>(sets.size()))) throw Cancelled();
    };
    for (std::size_t i = 0; i < sets.size(); ++i) {
        done = static_cast<double>(i);
        polls = 0;
        // The points are visited twice to find their neighbours, and once to count pairs.
        constexpr double kPointsAPoll = 1700;
        expected_polls = 1 + static_cast<double>(sets[i].size()) / kPointsAPoll;
        const Neighbours neighbours(sets[i], analysis.domain, poll);
        bond_orders.add(bond_order(neighbours));
        if (analysis.counts.least > 1)
            distributions.add(neighbours, radii.empty() ? std::nullopt : radii[i]);
    }
    analysis.bond_order = bond_orders.mean();
    if (analysis.counts.least < 2) return;
    analysis.distances = distributions.means();
    analysis.oscillations = oscillations(distributions.pair_correlation_mean());
}

Analysis analysed(std::span<const std::vector<Point>> sets, const Domain& domain,
                  std::span<const std::optional<double>> radii, const KeepGoing& keep_going,
                  double max_frequency) {
    // The times of both parts, for the progress. Four fifths of the spectrum's time are due to the
    // number of frequencies at the usual maximal frequency; the rest does not depend on it.
    const double spectrum = 1 + std::pow(max_frequency, 2);
    constexpr double kDistances = 9;
    const double share_of_spectrum = spectrum / (spectrum + kDistances);
    Analysis analysis{};
    analysis.domain = domain;
    analysis.max_frequency = max_frequency;
    analysis.sets = sets.size();
    analysis.counts = counts_of(sets);
    add_radius(analysis, sets, radii);
    analysis.spectrum = mean_spectrum(
        sets, domain, [&](double share) { return keep_going(share_of_spectrum * share); },
        max_frequency);
    analysis.radial = radial_of(analysis.spectrum);
    analysis.vertical_line = vertical_line(analysis.spectrum, analysis.radial);
    analysis.horizontal_line = horizontal_line(analysis.spectrum, analysis.radial);
    analysis.effective_nyquist = effective_nyquist(analysis.radial);
    add_distances(analysis, sets, radii, [&](double share) {
        return keep_going(share_of_spectrum + (1 - share_of_spectrum) * share);
    });
    return analysis;
}

}  // namespace

void check_effort(const Effort& effort) {
    range_for({1, 1, true}, 1, effort.max_frequency);
    check_threads(effort.threads);
}

void check_radius(double radius) {
    if (!std::isfinite(radius) || radius <= 0)
        throw BadRequest("radius", fmt::format("{}", radius),
                         "must be a finite number greater than 0");
}

Analysis analyse(std::span<const std::vector<Point>> given, const Domain& domain,
                 std::span<const std::optional<double>> radii, const KeepGoing& keep_going,
                 const Effort& effort) {
    check_domain(
        {.width = domain.width, .height = domain.height, .x0 = domain.x0, .y0 = domain.y0});
    std::vector<std::vector<Point>> moved;
    std::span<const std::vector<Point>> sets = given;
    if (domain.x0 != 0 || domain.y0 != 0) {
        moved.assign(given.begin(), given.end());
        for (std::vector<Point>& points : moved)
            for (Point& point : points) point = domain.from_corner(point);
        sets = moved;
    }
    for (const std::optional<double>& radius : radii)
        if (radius) check_radius(*radius);
    check_effort(effort);
    if (effort.threads == 0) {
        make_sure_of_threads();
        return analysed(sets, domain, radii, keep_going, effort.max_frequency);
    }
    const auto threads = static_cast<int>(effort.threads);
    make_sure_of_threads(threads);
    tbb::task_arena arena(threads);
    return arena.execute(
        [&] { return analysed(sets, domain, radii, keep_going, effort.max_frequency); });
}

}  // namespace lacuna::analysis

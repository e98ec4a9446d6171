// Histograms of distances, and comparison of means.
#include "distribution/statistics.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "portable/distance.h"

namespace lacuna::tests {
namespace {

constexpr double kLeast = 0.9;
constexpr double kMostPairs = 4.5;
constexpr double kMostNearest = 2.1;
constexpr std::size_t kBins = 36;

// Calls visit(i, j, distance in radii) for all pairs closer than `reach` radii on a torus.
template <typename Visit>
void for_each_pair(const Plan& plan, const std::vector<Sample>& samples, double reach,
                   Visit visit) {
    const auto cells =
        std::max(std::uint64_t{1}, static_cast<std::uint64_t>(plan.width / (reach * plan.radius)));
    const auto rows =
        std::max(std::uint64_t{1}, static_cast<std::uint64_t>(plan.height / (reach * plan.radius)));
    std::vector<std::vector<std::uint32_t>> grid(cells * rows);
    const auto column_of = [&](Sample s) { return std::uint64_t{s.x} * cells / plan.width; };
    const auto row_of = [&](Sample s) { return std::uint64_t{s.y} * rows / plan.height; };
    for (std::uint32_t i = 0; i < samples.size(); ++i)
        grid[column_of(samples[i]) * rows + row_of(samples[i])].push_back(i);

    for (std::uint32_t i = 0; i < samples.size(); ++i) {
        for (std::uint64_t dx = 0; dx < 3; ++dx) {
            for (std::uint64_t dy = 0; dy < 3; ++dy) {
                const std::uint64_t column = (column_of(samples[i]) + cells + dx - 1) % cells;
                const std::uint64_t row = (row_of(samples[i]) + rows + dy - 1) % rows;
                for (const std::uint32_t j : grid[column * rows + row]) {
                    if (j <= i) continue;
                    const double squared = static_cast<double>(portable::squared_length(
                        portable::axis_distance(samples[i].x, samples[j].x, plan.period_x),
                        portable::axis_distance(samples[i].y, samples[j].y, plan.period_y)));
                    const double distance = std::sqrt(squared) / plan.radius;
                    if (distance < reach) visit(i, j, distance);
                }
            }
        }
    }
}

std::size_t bin_of(double distance, double most) {
    const double share = (distance - kLeast) / (most - kLeast);
    return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, share * kBins)));
}

void divide(std::vector<double>& counts, std::size_t by) {
    for (double& count : counts) count /= static_cast<double>(by);
}

struct Moments {
    double mean = 0;
    double error_squared = 0;  // of the mean
};

Moments moments(const std::vector<std::vector<double>>& sets, std::size_t entry) {
    const auto n = static_cast<double>(sets.size());
    Moments result;
    for (const auto& set : sets) result.mean += set[entry] / n;
    for (const auto& set : sets) {
        const double off = set[entry] - result.mean;
        result.error_squared += off * off / (n - 1) / n;
    }
    return result;
}

}  // namespace

std::vector<double> pair_histogram(const Plan& plan, const std::vector<Sample>& samples) {
    std::vector<double> counts(kBins);
    for_each_pair(plan, samples, kMostPairs, [&](std::uint32_t, std::uint32_t, double distance) {
        counts[bin_of(distance, kMostPairs)] += 2;  // one of each
    });
    divide(counts, samples.size());
    return counts;
}

std::vector<double> nearest_histogram(const Plan& plan, const std::vector<Sample>& samples) {
    std::vector<double> nearest(samples.size(), kMostNearest);
    for_each_pair(plan, samples, kMostNearest,
                  [&](std::uint32_t i, std::uint32_t j, double distance) {
                      nearest[i] = std::min(nearest[i], distance);
                      nearest[j] = std::min(nearest[j], distance);
                  });
    std::vector<double> counts(kBins);
    for (const double distance : nearest) ++counts[bin_of(distance, kMostNearest)];
    divide(counts, samples.size());
    return counts;
}

bool Comparison::agree() const {
    // Two-sided normal quantile for 0.001 / entries, from its tail's asymptotic form.
    const double t = std::sqrt(2 * std::log(2 * std::max(1, entries) / 0.001));
    const double quantile = t - (std::log(t) + 0.5 * std::log(2 * 3.14159265358979)) / t;
    const double sum_limit = entries + 5 * std::sqrt(2.0 * entries);
    return largest_z < quantile + 0.3 && sum_z_squared < sum_limit;
}

std::string Comparison::text() const {
    std::ostringstream out;
    out << "largest |z| " << largest_z << ", sum of z^2 " << sum_z_squared << " over " << entries
        << " entries";
    return out.str();
}

Comparison compare(const std::vector<std::vector<double>>& a,
                   const std::vector<std::vector<double>>& b) {
    Comparison comparison;
    for (std::size_t entry = 0; entry < a.front().size(); ++entry) {
        const Moments left = moments(a, entry);
        const Moments right = moments(b, entry);
        const double error = std::sqrt(left.error_squared + right.error_squared);
        if (error == 0) continue;
        const double z = (left.mean - right.mean) / error;
        comparison.largest_z = std::max(comparison.largest_z, std::abs(z));
        comparison.sum_z_squared += z * z;
        ++comparison.entries;
    }
    return comparison;
}

void Sets::add(const Plan& plan, const std::vector<Sample>& samples, std::size_t count) {
    counts.push_back({static_cast<double>(count)});
    pairs.push_back(pair_histogram(plan, samples));
    nearest.push_back(nearest_histogram(plan, samples));
}

std::string Verdict::text() const {
    std::ostringstream out;
    out << "count |z| " << count_z << "\n  pairs: " << pairs.text()
        << "\n  nearest: " << nearest.text();
    return out.str();
}

Verdict compare(const Sets& a, const Sets& b) {
    return {compare(a.counts, b.counts).largest_z, compare(a.pairs, b.pairs),
            compare(a.nearest, b.nearest)};
}

Mean mean_of(const std::vector<double>& values) {
    std::vector<std::vector<double>> sets;
    for (const double value : values) sets.push_back({value});
    const Moments of_values = moments(sets, 0);
    return {of_values.mean, std::sqrt(of_values.error_squared)};
}

}  // namespace lacuna::tests

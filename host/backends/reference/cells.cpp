// Mode cells: the paper's section 4.2, written to be read beside it, in rounds (DESIGN section 3).
#include "backends/reference/cells.h"

#include <algorithm>

#include "plan/first_free.h"
#include "portable/distance.h"
#include "portable/metric.h"
#include "rounds/random.h"
#include "rounds/round_policy.h"

namespace lacuna::reference {
namespace {

// The lattice: which of its points a sample may still be placed on.
class Lattice {
public:
    explicit Lattice(const Plan& plan)
        : plan_(plan),
          is_free_(std::size_t{plan.lines} * plan.height),
          free_lengths_(first_free_lengths(plan)),
          widest_(*std::max_element(plan.radii->radii.begin(), plan.radii->radii.end()) / 256 + 1) {
        for (std::uint32_t x = 0; x < plan.lines; ++x)
            for (std::uint32_t y = 0; y < plan.height; ++y)
                is_free_[index_of(x, y)] = radius_at(x, y) != 0;
    }

    std::uint32_t free_length(std::uint32_t line) const { return free_lengths_[line]; }
    bool is_free(Sample sample) const { return is_free_[index_of(sample.x, sample.y)]; }
    // The rank-th free y of the line, counting from below.
    std::uint32_t y_at_rank(std::uint32_t line, std::uint64_t rank) const {
        std::uint32_t y = 0;
        while (!is_free_[index_of(line, y)] || rank-- > 0) ++y;
        return y;
    }

    // Loops over all lattice points that may be near enough, and takes those out that fail the
    // two-way check. With mean and max a point farther than the sample's radius may.
    void block(Sample sample) {
        const std::int64_t reach =
            plan_.metric == Metric::min ? radius_at(sample.x, sample.y) / 256 + 1 : widest_;
        for_each_within(sample.x, reach, plan_.lines, plan_.period_x, [&](std::uint32_t x) {
            for_each_within(sample.y, reach, plan_.height, plan_.period_y, [&](std::uint32_t y) {
                if (!is_free_[index_of(x, y)] || !conflict(sample, {x, y})) return;
                is_free_[index_of(x, y)] = false;
                --free_lengths_[x];
            });
        });
    }

private:
    std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{x} * plan_.height + y;
    }
    std::uint32_t radius_at(std::uint32_t x, std::uint32_t y) const {
        return plan_.radii->radii[plan_.radii->pixel_at(x, y)];
    }

    bool conflict(Sample a, Sample b) const {
        const std::uint32_t twice = portable::twice_metric_radius(
            static_cast<std::uint32_t>(plan_.metric), radius_at(a.x, a.y), radius_at(b.x, b.y));
        return portable::conflicts(a.x, a.y, b.x, b.y, plan_.period_x, plan_.period_y,
                                   portable::metric_squared(twice));
    }

    template <typename Visit>
    static void for_each_within(std::uint32_t centre, std::int64_t reach, std::uint32_t length,
                                std::uint32_t period, Visit visit) {
        const std::int64_t low = std::int64_t{centre} - reach;
        const std::int64_t high = std::int64_t{centre} + reach;
        if (period == 0 || 2 * reach + 1 >= length) {
            const std::int64_t from = period != 0 ? 0 : std::max<std::int64_t>(low, 0);
            const std::int64_t to =
                period != 0 ? length - 1 : std::min<std::int64_t>(high, length - 1);
            for (std::int64_t at = from; at <= to; ++at) visit(static_cast<std::uint32_t>(at));
            return;
        }
        for (std::int64_t at = low; at <= high; ++at)
            visit(static_cast<std::uint32_t>((at + length) % length));
    }

    const Plan& plan_;
    std::vector<bool> is_free_;
    std::vector<std::uint32_t> free_lengths_;
    std::int64_t widest_;
};

Sample draw(const Plan& plan, const Lattice& lattice, const std::vector<std::uint64_t>& cdf,
            std::uint64_t number) {
    const std::uint64_t c = scaled(random_bits(plan.seed, number).first, cdf.back());
    const auto line =
        static_cast<std::uint32_t>(std::upper_bound(cdf.begin(), cdf.end(), c) - cdf.begin());
    return {line, lattice.y_at_rank(line, c - (line == 0 ? 0 : cdf[line - 1]))};
}

}  // namespace

Outcome sample_cells(const Plan& plan, Observer& observer) {
    Outcome outcome;
    Lattice lattice(plan);
    RoundPolicy policy(plan);

    while (outcome.samples.size() < plan.limit) {
        std::vector<std::uint64_t> cdf(plan.lines);
        std::uint64_t sum = 0;
        for (std::uint32_t line = 0; line < plan.lines; ++line)
            cdf[line] = sum += lattice.free_length(line);
        if (sum == 0) break;  // every point with importance is blocked

        std::vector<Sample> candidates;
        const std::uint64_t first_number = outcome.draws;
        for (std::uint64_t i = 0; i < policy.size(); ++i)
            candidates.push_back(draw(plan, lattice, cdf, outcome.draws++));
        const std::size_t before = outcome.samples.size();
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (!lattice.is_free(candidates[i])) continue;
            lattice.block(candidates[i]);
            outcome.samples.push_back(candidates[i]);
            outcome.numbers.push_back(first_number + i);
        }
        outcome.rounds++;
        const std::uint64_t points = outcome.samples.size();
        if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
            throw Cancelled();
        policy.note(policy.size(), points - before, plan.lines, 1);
    }
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

}  // namespace lacuna::reference

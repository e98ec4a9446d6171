// The loop of the paper on surfaces and in volumes, written to be read: every sample is compared
// with every part. backends/reference/reference.cpp has it in the plane.
#include "space/reference.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "rounds/quota.h"
#include "rounds/random.h"
#include "rounds/round_policy.h"

namespace lacuna::space {
namespace {

class FreeSpace {
public:
    explicit FreeSpace(const Plan& plan) : plan_(plan), all_(*plan.space().first_bins) {
        for (std::uint32_t block = 0; block < all_.blocks(); ++block)
            for (std::uint32_t i = all_.begins[block]; i < all_.begins[block + 1]; ++i)
                bins_.emplace_back(all_.bins[i], block);
        for (const Position& kept : all_.kept) add(kept);
    }

    std::size_t bins() const { return bins_.size(); }
    // F: the running sum of the weights of all bins.
    std::vector<std::uint64_t> cdf() const {
        std::vector<std::uint64_t> cdf;
        std::uint64_t sum = 0;
        for (const auto& [part, block] : bins_) {
            const auto [length, width] = size_of(all_.weight_of(part, block));
            cdf.push_back(sum += std::uint64_t{length} * width);
        }
        return cdf;
    }
    SpaceSample draw(const std::vector<std::uint64_t>& cdf, std::uint64_t number) const {
        const RandomBits random = random_bits(plan_.seed, number);
        const std::uint64_t c = scaled(random.first, cdf.back());
        const auto bin = std::upper_bound(cdf.begin(), cdf.end(), c) - cdf.begin();
        const auto& [part, block] = bins_[static_cast<std::size_t>(bin)];
        return drawn(all_, part, block,
                     {static_cast<std::uint32_t>(random.second >> 32U),
                      static_cast<std::uint32_t>(random.second), third_bits(plan_, number)});
    }
    bool is_free(const SpaceSample& candidate) const {
        ask_after(samples_.size());
        return std::none_of(samples_.begin(), samples_.end(), [&](const Position& sample) {
            return squared_distance(sample, candidate.at) < plan_.radius_squared;
        });
    }
    // On a torus a sample is there nine times in each of three layers.
    void add(const Position& sample) {
        const auto [x, y, z] = all_.sides;
        const std::int32_t most = all_.wraps ? 1 : 0;
        for (std::int32_t k = -most; k <= most; ++k)
            for (std::int32_t j = -most; j <= most; ++j)
                for (std::int32_t i = -most; i <= most; ++i)
                    samples_.push_back(moved(sample, {i * x, j * y, k * z}));
    }
    // Splits bins, if that is wanted, and drops those that one sample covers.
    void refine(bool halve, std::uint64_t total) {
        const std::uint64_t least = least_weight_to_split(total, bins_.size());
        std::vector<std::pair<Portion, std::uint32_t>> kept;
        for (const auto& [part, block] : bins_) {
            const auto [length, width] = size_of(all_.weight_of(part, block));
            const bool splits =
                halve && std::uint64_t{length} * width >= least && can_be_split(all_, part, block);
            for (std::uint32_t i = 0; i < (splits ? pieces(all_) : 1); ++i) {
                const Portion piece = splits ? piece_of(all_, part, i) : part;
                if (all_.weight_of(piece, block) != 0 && !is_covered(piece, block))
                    kept.emplace_back(piece, block);
            }
        }
        bins_ = std::move(kept);
    }

private:
    bool is_covered(const Portion& part, std::uint32_t block) const {
        ask_after(samples_.size());
        const Corners corners(all_, part, block);
        return std::any_of(samples_.begin(), samples_.end(), [&](const Position& sample) {
            return corners.are_within(sample, plan_.radius_squared);
        });
    }

    const Plan& plan_;
    const FirstBins& all_;
    std::vector<std::pair<Portion, std::uint32_t>> bins_;  // each with its block
    std::vector<Position> samples_;
};

}  // namespace

OutcomeOf<SpaceSample> reference_samples(const Plan& plan, Observer& observer) {
    OutcomeOf<SpaceSample> outcome;
    FreeSpace space(plan);
    RoundPolicy policy(plan);
    Quota quota(plan);
    while (!quota.is_met()) {
        const std::vector<std::uint64_t> cdf = space.cdf();
        if (cdf.empty()) break;  // nothing is free: the set is maximal
        std::vector<SpaceSample> survivors;
        for (std::uint64_t i = 0; i < policy.size(); ++i) {
            const SpaceSample candidate = space.draw(cdf, plan.first_draw + outcome.draws++);
            if (space.is_free(candidate)) survivors.push_back(candidate);
        }
        std::vector<SpaceSample> added;
        for (const SpaceSample& candidate : survivors) {
            if (!space.is_free(candidate)) continue;
            space.add(candidate.at);
            added.push_back(candidate);
        }
        space.refine(policy.halves(), cdf.back());
        outcome.rounds++;
        const std::span<const SpaceSample> wanted = quota.wanted<SpaceSample>(added);
        outcome.samples.insert(outcome.samples.end(), wanted.begin(), wanted.end());
        const std::uint64_t points = outcome.samples.size();
        if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
            throw Cancelled();
        policy.note(survivors.size(), added.size(), space.bins(), 0);
    }
    outcome.count = outcome.samples.size();
    outcome.is_cut = quota.is_met();
    return outcome;
}

}  // namespace lacuna::space

// The loop of the paper, written to be read beside it: build the cdf, invert it for x, pick y on
// that line, subtract the disk (sections 3, 4.1 and 4.2).
//
// A round (docs/design.md, section 3) inverts one cdf and picks y several times. In the order of
// the draws, it keeps a candidate unless a sample kept earlier covers it. Each mode says what is
// free and how a sample is cut from it: lines.cpp, exact.cpp, cells.cpp.
#include "backends/reference/reference.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "backends/reference/free_space.h"
#include "base/polling.h"
#include "rounds/copy_shares.h"
#include "rounds/quota.h"
#include "rounds/random.h"
#include "rounds/round_policy.h"

namespace lacuna::reference {
namespace {

// Between two polls 128 draws are made: each walks along a line or a column of the lattice.
constexpr std::size_t kWorkOfDraw = kBetweenPolls / 128;

std::unique_ptr<FreeSpace> make_free_space(const Plan& plan) {
    if (plan.is_exact()) return make_exact(plan);
    if (plan.is_cells()) return make_cells(plan);
    return make_lines(plan);
}

// F_X: the running sum of the bins' weights. A bin weighs its free length (Eq. 1), or its area if
// widths differ, or, with uniform-x, 1 while it has free length.
std::vector<std::uint64_t> marginal_cdf(const Plan& plan, const FreeSpace& space) {
    const std::span<const std::uint32_t> lengths = space.free_lengths();
    std::vector<std::uint64_t> cdf(lengths.size());
    std::uint64_t sum = 0;
    const std::span<const std::uint32_t> widths = space.bin_widths();
    for (std::size_t bin = 0; bin < lengths.size(); ++bin) {
        const std::uint64_t width = widths.empty() ? 1 : widths[bin];
        cdf[bin] = sum += plan.is_uniform_x() ? std::min(lengths[bin], 1u) : width * lengths[bin];
    }
    return cdf;
}

// With classes: how random bits are shared among the copies, whose bins follow each other.
std::optional<CopyShares> shares_of_copies(const Plan& plan, const FreeSpace& space,
                                           const std::vector<std::uint64_t>& cdf) {
    if (!plan.has_radius_field() || !plan.field().copies.are_several()) return std::nullopt;
    const ClassCopies& copies = plan.field().copies;
    std::vector<std::uint64_t> areas(copies.count());
    for (std::uint32_t bin = 0; bin < cdf.size(); ++bin)
        areas[plan.class_of(space.at(bin, 0, 0))] = cdf[bin];
    std::vector<std::uint32_t> weights;
    for (std::uint32_t copy = 0; copy < copies.count(); ++copy) {
        if (copy > 0) areas[copy] = std::max(areas[copy], areas[copy - 1]);
        weights.push_back(copies.weight(copy));
    }
    return CopyShares(areas, weights);
}

struct Candidate {
    Sample sample;
    std::uint64_t number;  // number of its draw
};

Candidate draw(const Plan& plan, const FreeSpace& space, const std::vector<std::uint64_t>& cdf,
               const std::optional<CopyShares>& shares, std::uint64_t number) {
    const RandomBits random = random_bits(plan.seed, number);

    // Eq. 2: x = F_X^{-1}(c). The two values of F_X that straddle c give the bin.
    const std::uint64_t c =
        shares ? shares->area_at(random.first) : scaled(random.first, cdf.back());
    const auto above = std::upper_bound(cdf.begin(), cdf.end(), c);
    const auto bin = static_cast<std::uint32_t>(above - cdf.begin());

    // y: uniform over the free length of that bin, as is the excess of c over F_X.
    std::uint64_t rank = c - (bin == 0 ? 0 : cdf[bin - 1]);
    if (!space.bin_widths().empty()) {
        const std::uint32_t width = space.bin_widths()[bin];
        return {space.at(bin, static_cast<std::uint32_t>(rank / width),
                         static_cast<std::uint32_t>(rank % width)),
                number};
    }
    if (plan.is_uniform_x()) rank = scaled(random.second, space.free_lengths()[bin]);

    // x: on the line, or uniform in its strip, as interpolating the cdf makes it.
    const std::uint64_t bits =
        plan.is_uniform_x() ? random_bits(plan.seed, number, 1).first : random.second;
    const std::uint64_t offset =
        plan.snaps() ? plan.strip_width / 2 : scaled(bits, space.bin_width());
    return {space.at(bin, static_cast<std::uint32_t>(rank), static_cast<std::uint32_t>(offset)),
            number};
}

}  // namespace

void FreeSpace::end_round(std::span<const Sample>, const RoundPolicy&) {}

Outcome sample(const Plan& plan, Observer& observer) {
    Outcome outcome;
    const std::unique_ptr<FreeSpace> space = make_free_space(plan);
    RoundPolicy policy(plan);
    Quota quota(plan);

    while (!quota.is_met()) {
        const std::vector<std::uint64_t> cdf = marginal_cdf(plan, *space);
        if (cdf.empty() || cdf.back() == 0) break;  // nothing is free: the set is maximal
        const auto shares = shares_of_copies(plan, *space, cdf);

        // Survivors are the draws that no sample of an earlier round covers.
        std::vector<Candidate> survivors;
        for (std::uint64_t i = 0; i < policy.size(); ++i) {
            ask_after(kWorkOfDraw);
            const Candidate candidate =
                draw(plan, *space, cdf, shares, plan.first_draw + outcome.draws++);
            if (space->is_free(candidate.sample)) survivors.push_back(candidate);
        }
        const std::size_t before = outcome.samples.size();
        for (const auto& [candidate, number] : survivors) {
            ask_after(kWorkOfDraw);
            if (!space->is_free(candidate)) continue;
            space->add(candidate);
            outcome.samples.push_back(candidate);
            outcome.numbers.push_back(number);
        }
        const auto added = std::span(outcome.samples).subspan(before);
        space->end_round(added, policy);

        outcome.rounds++;
        const std::uint64_t points = outcome.samples.size();
        if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
            throw Cancelled();
        policy.note(survivors.size(), added.size(), space->free_lengths().size(),
                    space->bin_width());
        outcome.samples.resize(before + quota.wanted<Sample>(added).size());
    }
    outcome.count = outcome.samples.size();
    outcome.is_cut = quota.is_met();
    return outcome;
}

}  // namespace lacuna::reference

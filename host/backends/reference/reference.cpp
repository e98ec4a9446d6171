// Mode lines: the paper's section 4.1, written to be read beside it, in rounds (DESIGN section 3).
// Modes exact and cells are in exact.cpp and cells.cpp.
//
// The loop of the paper: build the cdf, invert it for x, pick y on that line, subtract the disk.
// A round does the first three several times from one cdf and keeps, in the order of the draws,
// what the samples kept before it in the round have not covered.
#include "backends/reference/reference.h"

#include <algorithm>

#include "backends/reference/cells.h"
#include "backends/reference/exact.h"
#include "backends/reference/free_space.h"
#include "rounds/random.h"
#include "rounds/round_policy.h"

namespace lacuna::reference {
namespace {

// F_X: the running sum of the lines' weights. A line weighs its free length (Eq. 1) or, with
// uniform-x, 1 while it has any.
std::vector<std::uint64_t> marginal_cdf(const Plan& plan, const FreeSpace& free_space) {
    std::vector<std::uint64_t> cdf(plan.lines);
    std::uint64_t sum = 0;
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        const std::uint32_t length = free_space.free_length(line);
        sum += plan.uniform_x ? (length > 0 ? 1 : 0) : length;
        cdf[line] = sum;
    }
    return cdf;
}

struct Candidate {
    Sample sample;
    std::uint32_t line;
    std::uint64_t number;  // of its draw
};

Candidate draw_candidate(const Plan& plan, const FreeSpace& free_space,
                         const std::vector<std::uint64_t>& cdf, std::uint64_t number) {
    const RandomBits random = random_bits(plan.seed, number);

    // Eq. 2: x = F_X^{-1}(c). The two values of F_X that straddle c give the line.
    const std::uint64_t c = scaled(random.first, cdf.back());
    const auto above = std::upper_bound(cdf.begin(), cdf.end(), c);
    const auto line = static_cast<std::uint32_t>(above - cdf.begin());
    const std::uint64_t below = line == 0 ? 0 : cdf[line - 1];

    // y: uniform over the free spans of that line. What c exceeds F_X by is already that.
    const std::uint64_t rank =
        plan.uniform_x ? scaled(random.second, free_space.free_length(line)) : c - below;
    const std::uint32_t y = free_space.y_at_rank(line, static_cast<std::uint32_t>(rank));

    // x: on the line, or uniform in its strip, as interpolating the cdf makes it.
    if (plan.snap) return {{plan.centre_of_line(line), y}, line, number};
    const std::uint64_t bits =
        plan.uniform_x ? random_bits(plan.seed, number, 1).first : random.second;
    const auto offset = static_cast<std::uint32_t>(scaled(bits, plan.strip_width));
    return {{line * plan.strip_width + offset, y}, line, number};
}

// In the order of the draws: a candidate is kept if no sample kept before it covers it.
std::uint64_t admit(const std::vector<Candidate>& candidates, FreeSpace& free_space,
                    Outcome& outcome) {
    std::uint64_t admitted = 0;
    for (const Candidate& candidate : candidates) {
        if (!free_space.is_free(candidate.line, candidate.sample.y)) continue;
        free_space.subtract_disk(candidate.sample);
        outcome.samples.push_back(candidate.sample);
        outcome.numbers.push_back(candidate.number);
        ++admitted;
    }
    return admitted;
}

}  // namespace

Outcome sample(const Plan& plan, Observer& observer) {
    if (plan.is_exact()) return sample_exact(plan, observer);
    if (plan.is_cells()) return sample_cells(plan, observer);
    Outcome outcome;
    FreeSpace free_space(plan);
    RoundPolicy policy(plan);

    while (outcome.samples.size() < plan.limit) {
        const std::vector<std::uint64_t> cdf = marginal_cdf(plan, free_space);
        if (cdf.back() == 0) break;  // no free span left: the set is maximal on the lines

        std::vector<Candidate> candidates;
        for (std::uint64_t i = 0; i < policy.size(); ++i)
            candidates.push_back(draw_candidate(plan, free_space, cdf, outcome.draws++));

        const std::uint64_t admitted = admit(candidates, free_space, outcome);
        outcome.rounds++;
        const std::uint64_t points = outcome.samples.size();
        if (!observer.keep_going({points, std::max(points, plan.expected_samples), outcome.rounds}))
            throw Cancelled();
        policy.note(policy.size(), admitted, plan.lines, plan.strip_width);
    }
    if (outcome.samples.size() > plan.limit) outcome.samples.resize(plan.limit);
    return outcome;
}

}  // namespace lacuna::reference

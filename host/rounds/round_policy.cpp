// Decides the size of rounds, and when to refine.
#include "rounds/round_policy.h"

#include <algorithm>

namespace lacuna {
namespace {

// The bins are judged by at least this many draws. The fraction that survives then has a standard
// deviation of about 3 %.
constexpr std::uint64_t kJudgedDraws = 256;

// The larger a round, the larger the fraction of its draws that earlier draws of the same round
// cover. Sizes are chosen so that this fraction is 1 / kLostInLines in lines and cells, and 1 /
// kLostInExact in exact. There it is larger, because each round has to refine, so fewer and larger
// rounds are faster.
constexpr std::uint64_t kLostInLines = 5;
constexpr std::uint64_t kLostInExact = 4;
// In space bins are not trimmed by chords, so each round splits them. Measured on surfaces and in
// volumes: one draw for 1.25 to 3 bins gives sets in the same time, to within 6 %.
constexpr std::uint64_t kBinsADraw = 2;

}  // namespace

std::uint64_t largest_round_size(const Plan& plan) {
    return plan.is_exact() ? kLargestRoundInExact : kLargestRoundInLines;
}

std::uint64_t first_round_size(const Plan& plan) {
    if (plan.round_size != 0) return plan.round_size;
    if (plan.is_cells() || plan.begins_with_boxes())
        return std::clamp(plan.maximal_samples / 6, kSmallestRound, largest_round_size(plan));
    const std::uint64_t area = std::uint64_t{plan.width} * plan.height;
    return std::clamp(area / plan.radius_squared / 8, kSmallestRound, largest_round_size(plan));
}

void RoundPolicy::judge_bins(std::uint64_t survivors, std::uint32_t width) {
    seen_ += size_;
    seen_survivors_ += survivors;
    if (seen_ < kJudgedDraws) {
        halves_ = false;
        return;
    }
    // Refine when fewer than two in five survive: then too many draws fall into covered space.
    halves_ = 5 * seen_survivors_ < 2 * seen_ && width > 1;
    refines_ = refines_ || halves_;
    seen_ = seen_survivors_ = 0;
}

// A round has as many draws as loses about half of them to earlier ones of the same round, but at
// most one for kBinsADraw bins. Bins are halved if there are that few, or if few draws survive.
void RoundPolicy::note_in_space(std::uint64_t survivors, std::uint64_t admitted,
                                std::uint64_t bins) {
    const std::uint64_t lost = survivors - admitted;
    const std::uint64_t wanted = lost == 0 ? 2 * size_ : size_ * size_ / (2 * lost);
    const bool few_survive = 5 * survivors < 2 * size_;
    const std::uint64_t next = std::clamp(wanted, size_ / 2, 2 * size_);
    size_ =
        std::clamp(std::min(next, bins / kBinsADraw), kSmallestRound, largest_round_size(plan_));
    halves_ = few_survive || 2 * kBinsADraw * size_ >= bins;
}

void RoundPolicy::note(std::uint64_t survivors, std::uint64_t admitted, std::uint64_t bins,
                       std::uint32_t bin_width) {
    if (plan_.is_space() && plan_.round_size == 0) {
        note_in_space(survivors, admitted, bins);
        return;
    }
    const bool are_boxes = refines_;
    // With a radius field boxes are cut along y too, so their width does not matter. In space bins
    // have none.
    constexpr std::uint32_t kAnyWidth = 2;
    if (plan_.is_exact()) judge_bins(survivors, plan_.begins_with_boxes() ? kAnyWidth : bin_width);
    if (plan_.round_size != 0) return;

    const std::uint64_t lost = survivors - admitted;
    const std::uint64_t share = plan_.is_exact() ? kLostInExact : kLostInLines;
    const std::uint64_t wanted = lost == 0 ? 2 * size_ : size_ * size_ / (share * lost);
    // Fewer draws will be lost to earlier rounds once the boxes are halved, and a box has room for
    // only one or two samples. So a larger round is not needed.
    std::uint64_t most = std::min(halves_ ? size_ : 2 * size_, largest_round_size(plan_));
    if (are_boxes) most = std::min(most, bins + kJudgedDraws);
    // In exact no round may need more memory than the first, whose size is proportional to the set.
    if (plan_.is_exact()) most = std::min(most, std::max(first_round_size(plan_), kJudgedDraws));
    size_ = std::max(std::min(std::max(wanted, size_ / 2), most), kSmallestRound);
}

}  // namespace lacuna

// The size of rounds, and the time to refine.
#include "rounds/round_policy.h"

#include <algorithm>

namespace lacuna {
namespace {

// Whether places are worth drawing from is judged by kJudgedDraws draws or more: the share of them
// that survives then has a standard deviation of about 3 in 100.
constexpr std::uint64_t kJudgedDraws = 256;

// The larger a round is, the larger is the share of its draws that earlier draws of the same round
// cover. Sizes are chosen so that this share is 1 / kLostInLines in lines and cells. In exact a
// round costs more beside its draws, by refine: fewer and larger rounds are best, and the share is
// 1 / kLostInExact.
constexpr std::uint64_t kLostInLines = 5;
constexpr std::uint64_t kLostInExact = 4;

}  // namespace

std::uint64_t largest_round_size(const Plan& plan) {
    return plan.is_exact() ? kLargestRoundInExact : kLargestRoundInLines;
}

std::uint64_t first_round_size(const Plan& plan) {
    if (plan.round_size != 0) return plan.round_size;
    if (plan.is_cells() || plan.radius_field)
        return std::clamp(plan.maximal_samples / 6, kSmallestRound, largest_round_size(plan));
    const std::uint64_t area = std::uint64_t{plan.width} * plan.height;
    return std::clamp(area / plan.radius_squared / 8, kSmallestRound, largest_round_size(plan));
}

void RoundPolicy::judge_places(std::uint64_t survivors, std::uint32_t width) {
    seen_ += size_;
    seen_survivors_ += survivors;
    if (seen_ < kJudgedDraws) {
        halves_ = false;
        return;
    }
    // Fewer than two in five survive: the places hold more covered space than is worth drawing
    // from.
    halves_ = 5 * seen_survivors_ < 2 * seen_ && width > 1;
    refines_ = refines_ || halves_;
    seen_ = seen_survivors_ = 0;
}

void RoundPolicy::note(std::uint64_t survivors, std::uint64_t admitted, std::uint64_t places,
                       std::uint32_t bin_width) {
    const bool are_boxes = refines_;
    // With a radius field places are cut along y too.
    constexpr std::uint32_t kAnyWidth = 2;
    if (plan_.is_exact()) judge_places(survivors, plan_.radius_field ? kAnyWidth : bin_width);
    if (plan_.round_size != 0) return;

    const std::uint64_t lost = survivors - admitted;
    const std::uint64_t share = plan_.is_exact() ? kLostInExact : kLostInLines;
    const std::uint64_t wanted = lost == 0 ? 2 * size_ : size_ * size_ / (share * lost);
    // Halved places will lose fewer draws to earlier rounds, and a box has room for one sample or
    // two: no need for more draws than that.
    std::uint64_t most = std::min(halves_ ? size_ : 2 * size_, largest_round_size(plan_));
    if (are_boxes) most = std::min(most, places + kJudgedDraws);
    // No round needs more memory than the first, whose size is a share of the set's.
    if (plan_.is_exact()) most = std::min(most, std::max(first_round_size(plan_), kJudgedDraws));
    size_ = std::max(std::min(std::max(wanted, size_ / 2), most), kSmallestRound);
}

}  // namespace lacuna

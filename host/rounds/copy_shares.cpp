// Shares of 64 random bits.
#include "rounds/copy_shares.h"

#include <cstddef>

#include "rounds/random.h"

namespace lacuna {
namespace {

__extension__ using Wide = unsigned __int128;

}  // namespace

CopyShares::CopyShares(std::span<const std::uint64_t> areas_up_to,
                       std::span<const std::uint32_t> weights) {
    const auto area_of = [&](std::size_t copy) {
        return areas_up_to[copy] - (copy == 0 ? 0 : areas_up_to[copy - 1]);
    };
    Wide all = 0;
    for (std::size_t copy = 0; copy < weights.size(); ++copy)
        all += Wide{area_of(copy)} * weights[copy];
    // Shares are computed from the highest 64 bits of the sums.
    unsigned shift = 0;
    while ((all >> shift >> 64) != 0) ++shift;
    const auto total = static_cast<std::uint64_t>(all >> shift);
    if (total == 0) return;
    Wide sum = 0;
    Wide first = 0;
    for (std::size_t copy = 0; copy < weights.size(); ++copy) {
        sum += Wide{area_of(copy)} * weights[copy];
        const Wide end = (sum >> shift << 64) / total;
        if (end != first)
            shares_.push_back({static_cast<std::uint64_t>(first),
                               static_cast<std::uint64_t>(end - first),
                               areas_up_to[copy] - area_of(copy), area_of(copy)});
        first = end;
    }
}

std::uint64_t CopyShares::area_at(std::uint64_t bits) const {
    std::size_t i = shares_.size() - 1;
    while (bits < shares_[i].first_bits) --i;
    const auto& [first_bits, width, before, area] = shares_[i];
    if (width == 0) return before + scaled(bits, area);
    return before + static_cast<std::uint64_t>(Wide{bits - first_bits} * area / width);
}

}  // namespace lacuna

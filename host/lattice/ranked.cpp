// A radix sort. Unlike std::sort it can stop after any number of elements, and it is faster here.
#include "lattice/ranked.h"

#include <array>
#include <cstddef>

namespace lacuna::relaxing {

void sort_by_rank(std::vector<Ranked>& all, const Poll& poll) {
    constexpr unsigned kBits = 11, kRankBits = 64;
    constexpr std::size_t kDigits = std::size_t{1} << kBits;
    std::vector<Ranked> sorted(all.size());
    for (unsigned shift = 0; shift < kRankBits; shift += kBits) {
        const auto digit = [&](const Ranked& one) { return (one.rank >> shift) % kDigits; };
        std::array<std::size_t, kDigits> next{};  // where the next element with this digit goes
        for_each_polled(all.size(), poll, [&](std::size_t i) { ++next[digit(all[i])]; });
        if (!all.empty() && next[digit(all.front())] == all.size()) continue;
        std::size_t before = 0;
        for (std::size_t& place : next) {
            const std::size_t count = place;
            place = before;
            before += count;
        }
        for_each_polled(all.size(), poll,
                        [&](std::size_t i) { sorted[next[digit(all[i])]++] = all[i]; });
        all.swap(sorted);
    }
}

}  // namespace lacuna::relaxing

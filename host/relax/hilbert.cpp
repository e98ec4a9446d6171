// Orders sites along Hilbert's curve.
#include "relax/hilbert.h"

#include <cstddef>
#include <utility>

#include "relax/ranked.h"

namespace lacuna::relaxing {
namespace {

// The rank of a position on Hilbert's curve through the square of 2^30 units.
std::uint64_t hilbert_rank(std::uint32_t x, std::uint32_t y) {
    std::uint64_t rank = 0;
    for (std::uint32_t side = 1u << 29; side > 0; side /= 2) {
        const bool right = (x & side) != 0;
        const bool upper = (y & side) != 0;
        rank = 4 * rank + (right ? (upper ? 2u : 3u) : (upper ? 1u : 0u));
        if (upper) continue;
        if (right) {
            x = ~x;
            y = ~y;
        }
        std::swap(x, y);
    }
    return rank;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Site> sites, const Poll& poll) {
    std::vector<Ranked> ranked(sites.size());
    for_each_polled(sites.size(), poll, [&](std::size_t i) {
        ranked[i] = {hilbert_rank(sites[i].x, sites[i].y), static_cast<std::uint32_t>(i)};
    });
    sort_by_rank(ranked, poll);
    std::vector<std::uint32_t> order(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = ranked[i].index;
    return order;
}

}  // namespace lacuna::relaxing

// Orders sites along Hilbert's curve.
#include "relax/hilbert.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "lattice/ranked.h"

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

// Half the perimeter of the smallest rectangle around sites, and its area.
struct Extent {
    double half_perimeter;
    double area;
};

Extent extent_of(std::span<const Site> sites) {
    std::uint32_t left = sites.front().x, right = left, bottom = sites.front().y, top = bottom;
    for (const Site& site : sites) {
        left = std::min(left, site.x);
        right = std::max(right, site.x);
        bottom = std::min(bottom, site.y);
        top = std::max(top, site.y);
    }
    const double width = right - left, height = top - bottom;
    return {width + height, width * height};
}

// Whether runs of sites are compact, as those of a stratified set are, which follow a curve of this
// kind. On Hilbert's curve a run of even density has 2 to 3 times the root of its area; in rows it
// has 8 times that.
bool are_on_a_curve(std::span<const Site> sites) {
    constexpr std::size_t kRun = 64;
    constexpr double kCompact = 4;
    const std::size_t runs = sites.size() / kRun;
    if (runs == 0) return false;
    double sum = 0;
    for (std::size_t i = 0; i < runs; ++i)
        sum += extent_of(sites.subspan(i * kRun, kRun)).half_perimeter;
    return sum <= kCompact * std::sqrt(static_cast<double>(runs) * extent_of(sites).area);
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Site> sites, const Poll& poll) {
    std::vector<std::uint32_t> order(sites.size());
    if (are_on_a_curve(sites)) {
        std::iota(order.begin(), order.end(), 0U);
        return order;
    }
    std::vector<Ranked> ranked(sites.size());
    for_each_polled(sites.size(), poll, [&](std::size_t i) {
        ranked[i] = {hilbert_rank(sites[i].x, sites[i].y), static_cast<std::uint32_t>(i)};
    });
    sort_by_rank(ranked, poll);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = ranked[i].index;
    return order;
}

}  // namespace lacuna::relaxing

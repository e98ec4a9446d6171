// Counts dots in blocks, and moves some from full blocks to empty ones.
#include "recipes/stipple/jump.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lacuna::recipes {
namespace {

// A grid of blocks with about nine dots each, if dots are spread evenly.
class Blocks {
public:
    Blocks(const Domain& domain, std::size_t dots) : domain_(domain) {
        const double side = 3 * std::sqrt(domain.width * domain.height / static_cast<double>(dots));
        columns_ = std::max(1.0, std::floor(domain.width / side));
        rows_ = std::max(1.0, std::floor(domain.height / side));
    }
    std::size_t count() const { return static_cast<std::size_t>(columns_ * rows_); }
    std::size_t of(Point dot) const {
        const Point way = domain_.from_corner(dot);
        const double column = std::min(columns_ - 1, std::floor(way.x / domain_.width * columns_));
        const double row = std::min(rows_ - 1, std::floor(way.y / domain_.height * rows_));
        return static_cast<std::size_t>(row * columns_ + column);
    }

private:
    const Domain& domain_;
    double columns_;
    double rows_;
};

using Counts = std::vector<std::int64_t>;

Counts counts_of(std::span<const Point> dots, const Blocks& blocks) {
    Counts counts(blocks.count());
    for (const Point& dot : dots) ++counts[blocks.of(dot)];
    return counts;
}

// The indices of dots of blocks that have clearly more dots than others say: of each such block as
// many as it has more, spread over its dots.
std::vector<std::size_t> surplus(std::span<const Point> dots, const Counts& counts,
                                 const Counts& others, const Blocks& blocks) {
    std::vector<std::size_t> chosen;
    Counts passed(blocks.count());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const std::size_t block = blocks.of(dots[i]);
        const std::int64_t more = counts[block] - others[block];
        // Relaxed dots and dots placed anew differ by so many in a still picture.
        const std::int64_t usual = 3 + std::min(counts[block], others[block]) / 8;
        const std::int64_t before = passed[block]++ * more / counts[block];
        if (more > usual && passed[block] * more / counts[block] > before) chosen.push_back(i);
    }
    return chosen;
}

}  // namespace

std::vector<Point> jumped(std::span<const Point> dots, std::span<const Point> fair,
                          const Domain& domain) {
    const Blocks blocks(domain, dots.size());
    const Counts have = counts_of(dots, blocks), wanted = counts_of(fair, blocks);
    const std::vector<std::size_t> from = surplus(dots, have, wanted, blocks);
    const std::vector<std::size_t> to = surplus(fair, wanted, have, blocks);
    std::vector<Point> all(dots.begin(), dots.end());
    const std::size_t jumps = std::min(from.size(), to.size());
    for (std::size_t k = 0; k < jumps; ++k)
        all[from[k * from.size() / jumps]] = fair[to[k * to.size() / jumps]];
    return all;
}

}  // namespace lacuna::recipes

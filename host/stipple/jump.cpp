// Counts dots in blocks, and moves some from blocks with too many to blocks with too few.
#include "stipple/jump.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "stipple/dot_size.h"

namespace lacuna::stippling {
namespace {

// A grid of square blocks, a little wider than `side`.
class Blocks {
public:
    Blocks(const Domain& domain, double side)
        : domain_(domain),
          columns_(std::max(1.0, std::floor(domain.width / side))),
          rows_(std::max(1.0, std::floor(domain.height / side))) {}
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

// By how much the numbers of relaxed dots and of dots placed anew differ in a block of a still
// picture, of which the smaller one is this. They differ along the block's edges alone.
double usual_difference(std::int64_t count) {
    return 3 * std::sqrt(std::sqrt(static_cast<double>(count) + 1));
}

// The indices of dots that lie in blocks with too many of them. `counts` are the numbers of these
// dots in the blocks, `wanted` the numbers that there should be. Each block gives as many dots as
// it has too many, evenly spread over its dots, if they are more than usual, or in any case.
std::vector<std::size_t> surplus(std::span<const Point> dots, const Counts& counts,
                                 const Counts& wanted, const Blocks& blocks, bool in_any_case) {
    std::vector<std::size_t> chosen;
    Counts passed(blocks.count());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const std::size_t block = blocks.of(dots[i]);
        const std::int64_t more = counts[block] - wanted[block];
        const double usual = usual_difference(std::min(counts[block], wanted[block]));
        if (more <= 0 || (!in_any_case && static_cast<double>(more) <= usual)) continue;
        const std::int64_t before = passed[block]++ * more / counts[block];
        if (passed[block] * more / counts[block] > before) chosen.push_back(i);
    }
    return chosen;
}

// Dots, and the places where they may jump to, each once.
class Jumps {
public:
    Jumps(std::span<Point> dots, std::span<const Point> places)
        : dots_(dots), places_(places), taken_(places.size()) {}

    // Lets as many of these dots jump as there are free ones among these places, evenly chosen.
    void jump(const std::vector<std::size_t>& from, std::vector<std::size_t> to) {
        to.erase(std::remove_if(to.begin(), to.end(), [&](std::size_t i) { return taken_[i]; }),
                 to.end());
        const std::size_t jumps = std::min(from.size(), to.size());
        for (std::size_t k = 0; k < jumps; ++k) {
            const std::size_t place = to[k * to.size() / jumps];
            dots_[from[k * from.size() / jumps]] = places_[place];
            taken_[place] = true;
        }
    }

private:
    std::span<Point> dots_;
    std::span<const Point> places_;
    std::vector<bool> taken_;
};

}  // namespace

std::vector<Point> jumped(std::span<const Point> dots, std::span<const Point> fair,
                          const Field& field, const Domain& domain) {
    constexpr double kWidest = 24, kNarrowest = 0.7;  // of blocks, in mean spacings of dots
    const double spacing =
        std::sqrt(domain.width * domain.height / static_cast<double>(dots.size()));
    std::vector<Point> all(dots.begin(), dots.end());
    Jumps jumps(all, fair);
    for (double side = kWidest; side > kNarrowest; side /= 2) {
        const Blocks blocks(domain, side * spacing);
        const Counts have = counts_of(all, blocks), wanted = counts_of(fair, blocks);
        jumps.jump(surplus(all, have, wanted, blocks, false),
                   surplus(fair, wanted, have, blocks, false));
    }
    const auto on_white = [&] {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (stippling::importance_at(all[i], field, domain) == 0) found.push_back(i);
        return found;
    };
    const Blocks blocks(domain, kNarrowest * spacing);
    jumps.jump(on_white(),
               surplus(fair, counts_of(fair, blocks), counts_of(all, blocks), blocks, true));
    std::vector<std::size_t> anywhere(fair.size());
    std::iota(anywhere.begin(), anywhere.end(), std::size_t{0});
    jumps.jump(on_white(), anywhere);
    return all;
}

}  // namespace lacuna::stippling

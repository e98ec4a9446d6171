// Builds the tree, and finds the first bound of power.
#include "relax/cpu/site_tree.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace lacuna::relaxing::cpu {
namespace {

template <typename Node>
Node around(const Node& a, const Node& b) {
    return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.bottom, b.bottom),
            std::max(a.top, b.top), std::min(a.least_weight, b.least_weight)};
}

}  // namespace

void SiteTree::look_at(std::span<const Site> sites, Workers& workers) {
    sites_ = sites;
    std::size_t below = sites.size();
    levels_.reserve(16);
    for (std::size_t level = 0; level == 0 || below > 1; ++level) {
        const std::size_t nodes = (below + kFan - 1) / kFan;
        if (levels_.size() <= level) levels_.emplace_back();
        levels_[level].resize(nodes);
        constexpr std::size_t kNodesPerTask = 512;
        const std::size_t tasks = (nodes + kNodesPerTask - 1) / kNodesPerTask;
        workers.for_columns(static_cast<std::uint32_t>(tasks), nodes, [&](std::uint32_t task) {
            const std::size_t end = std::min(nodes, (task + std::size_t{1}) * kNodesPerTask);
            for (std::size_t node = task * kNodesPerTask; node < end; ++node) {
                const auto child = [&](std::size_t i) {
                    if (level != 0) return levels_[level - 1][i];
                    const Site& site = sites_[i];
                    return Node{site.x, site.x, site.y, site.y, site.weight};
                };
                Node all = child(node * kFan);
                for (std::size_t i = node * kFan + 1; i < children_end(level, node); ++i)
                    all = around(all, child(i));
                levels_[level][node] = all;
            }
        });
        below = nodes;
    }
}

std::uint64_t SiteTree::worst_power(const Site& site, const Rectangle& box) {
    const std::int64_t x = site.x;
    const std::int64_t y = site.y;
    const auto dx =
        static_cast<std::uint64_t>(std::max(std::abs(x - box.left), std::abs(x - box.right)));
    const auto dy =
        static_cast<std::uint64_t>(std::max(std::abs(y - box.bottom), std::abs(y - box.top)));
    return dx * dx + dy * dy + site.weight;
}

std::uint64_t SiteTree::least_worst_power(const Rectangle& box, std::uint64_t bound) const {
    const std::size_t root = levels_.size() - 1;
    if (least_power(levels_[root].front(), box) < bound) lower_worst_power(root, 0, box, bound);
    return bound;
}

// The nearest child comes first: it lowers the bound so far that most others are skipped.
void SiteTree::lower_worst_power(std::size_t level, std::size_t node, const Rectangle& box,
                                 std::uint64_t& bound) const {
    const std::size_t begin = node * kFan;
    const std::size_t end = children_end(level, node);
    if (level == 0) {
        for (std::size_t i = begin; i < end; ++i)
            bound = std::min(bound, worst_power(sites_[i], box));
        return;
    }
    std::array<std::uint64_t, kFan> powers{};
    for (std::size_t i = begin; i < end; ++i)
        powers[i - begin] = least_power(levels_[level - 1][i], box);
    const auto nearest = static_cast<std::size_t>(
        std::min_element(powers.begin(),
                         powers.begin() + static_cast<std::ptrdiff_t>(end - begin)) -
        powers.begin());
    if (powers[nearest] < bound) lower_worst_power(level - 1, begin + nearest, box, bound);
    for (std::size_t i = 0; i < end - begin; ++i)
        if (i != nearest && powers[i] < bound) lower_worst_power(level - 1, begin + i, box, bound);
}

}  // namespace lacuna::relaxing::cpu

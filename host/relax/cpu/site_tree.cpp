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

// A site's own leaf comes first: it is near, so that most other leaves are skipped. One search
// serves a block. Lists are filtered without branches, because these would be hard to predict.
void SiteTree::lower_to_nearest(std::size_t block, std::int64_t period_x, std::int64_t period_y,
                                Neighbours& near, std::span<std::uint64_t, kBlock> nearest) const {
    const std::size_t first = block * (kBlock / kFan);
    const std::size_t end = std::min(first + kBlock / kFan, levels_.front().size());
    std::array<std::uint64_t, kBlock / kFan> farthest{};  // of each leaf's distances
    for (std::size_t leaf = first; leaf < end; ++leaf) {
        const auto own = nearest.subspan((leaf - first) * kFan, kFan);
        lower_within(leaf, own);
        farthest[leaf - first] = *std::max_element(own.begin(), own.end());
    }
    const std::uint64_t all = *std::max_element(farthest.begin(), farthest.end());
    const Node& box = levels_[std::min<std::size_t>(1, levels_.size() - 1)][block];
    const int images = period_x != 0 ? 1 : 0;
    for (int image = 0; image < (2 * images + 1) * (2 * images + 1); ++image) {
        const std::int64_t x = (image % 3 - images) * period_x;
        const std::int64_t y = (image / 3 - images) * period_y;
        find_leaves(moved(box, x, y), all, near);
        for (std::size_t leaf = first; leaf < end; ++leaf) {
            keep_near(0, moved(levels_.front()[leaf], x, y), farthest[leaf - first], near.of_block,
                      near.of_leaf);
            if (x == 0 && y == 0) std::erase(near.of_leaf, leaf);
            lower_by_leaves(leaf, x, y, near, nearest.subspan((leaf - first) * kFan));
        }
    }
}

// By the sites of the leaves near.of_leaf. The leaf's own sites are shifted by (x, y).
void SiteTree::lower_by_leaves(std::size_t leaf, std::int64_t x, std::int64_t y, Neighbours& near,
                               std::span<std::uint64_t> nearest) const {
    if (near.of_leaf.empty()) return;
    for (std::size_t i = leaf * kFan; i < children_end(0, leaf); ++i) {
        const std::int64_t at_x = sites_[i].x + x;
        const std::int64_t at_y = sites_[i].y + y;
        std::uint64_t least = nearest[i - leaf * kFan];
        keep_near(0, {at_x, at_x, at_y, at_y}, least, near.of_leaf, near.of_site);
        for (const std::size_t other : near.of_site)
            for (std::size_t j = other * kFan; j < children_end(0, other); ++j)
                if (j != i)
                    least = std::min(least, squared(sites_[j].x - at_x, sites_[j].y - at_y));
        nearest[i - leaf * kFan] = least;
    }
}

// By the other sites of the same leaf.
void SiteTree::lower_within(std::size_t leaf, std::span<std::uint64_t> nearest) const {
    const auto sites = sites_.subspan(leaf * kFan, children_end(0, leaf) - leaf * kFan);
    for (std::size_t i = 1; i < sites.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::uint64_t distance = squared(std::int64_t{sites[i].x} - sites[j].x,
                                                   std::int64_t{sites[i].y} - sites[j].y);
            nearest[i] = std::min(nearest[i], distance);
            nearest[j] = std::min(nearest[j], distance);
        }
}

void SiteTree::keep_near(std::size_t level, const Rectangle& box, std::uint64_t distance,
                         const std::vector<std::size_t>& nodes,
                         std::vector<std::size_t>& kept) const {
    kept.resize(nodes.size());
    std::size_t count = 0;
    for (const std::size_t node : nodes) {
        kept[count] = node;
        count += std::size_t{squared_gap(levels_[level][node], box) < distance};
    }
    kept.resize(count);
}

// Puts the leaves that are nearer to the rectangle than `distance`, squared, into near.of_block.
void SiteTree::find_leaves(const Rectangle& box, std::uint64_t distance, Neighbours& near) const {
    near.of_block.assign(1, 0);
    for (std::size_t level = levels_.size() - 1;; --level) {
        keep_near(level, box, distance, near.of_block, near.of_leaf);
        if (level == 0) break;
        near.of_block.clear();
        for (const std::size_t node : near.of_leaf)
            for (std::size_t child = node * kFan; child < children_end(level, node); ++child)
                near.of_block.push_back(child);
    }
    near.of_block.swap(near.of_leaf);
}

}  // namespace lacuna::relaxing::cpu

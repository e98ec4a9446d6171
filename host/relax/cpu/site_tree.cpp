// Builds the tree, and finds the first bound of power.
#include "relax/cpu/site_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include "relax/cpu/wide.h"

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
    rounded_.resize((sites.size() + kFan - 1) / kFan);
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
                if (level == 0) round_sites_of(node);
            }
        });
        below = nodes;
    }
}

void SiteTree::round_sites_of(std::size_t leaf) {
    Rounded& its = rounded_[leaf];
    its.x.fill(std::numeric_limits<float>::infinity());
    its.y.fill(std::numeric_limits<float>::infinity());
    for (std::size_t i = leaf * kFan; i < children_end(0, leaf); ++i) {
        its.x[i % kFan] = static_cast<float>(sites_[i].x);
        its.y[i % kFan] = static_cast<float>(sites_[i].y);
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

// One search serves a block. Lists are filtered without branches, because these would be hard to
// predict.
void SiteTree::lower_to_nearest(std::size_t block, std::int64_t period_x, std::int64_t period_y,
                                Neighbours& near, std::span<std::uint64_t, kBlock> nearest) const {
    const std::size_t first = block * (kBlock / kFan);
    const std::size_t end = std::min(first + kBlock / kFan, levels_.front().size());
    const auto farthest = [&](std::size_t leaf) {
        const auto own = nearest.subspan((leaf - first) * kFan, kFan);
        return *std::max_element(own.begin(), own.end());
    };
    const std::uint64_t all = *std::max_element(nearest.begin(), nearest.end());
    const Node& box = levels_[std::min<std::size_t>(1, levels_.size() - 1)][block];
    const int images = period_x != 0 ? 1 : 0;
    for (int image = 0; image < (2 * images + 1) * (2 * images + 1); ++image) {
        const std::int64_t x = (image % 3 - images) * period_x;
        const std::int64_t y = (image / 3 - images) * period_y;
        const auto of_block = find_leaves(moved(box, x, y), all, near);
        for (std::size_t leaf = first; leaf < end; ++leaf) {
            const auto of_leaf = keep_near(0, moved(levels_.front()[leaf], x, y), farthest(leaf),
                                           of_block, near.of_leaf);
            lower_by_leaves(leaf, x, y, of_leaf, nearest.subspan((leaf - first) * kFan));
        }
    }
}

// A squared distance in single precision. Of two sites that are nearer than `distance`, also
// squared, the rounded places are nearer than it. Sites and their images are at most three times as
// far from 0 as the last site.
float SiteTree::rounded_reach(std::uint64_t distance) const {
    constexpr float kPlaces = 0x1p-20F;     // of a coordinate: far more than its rounding
    constexpr float kProducts = 1.000001F;  // of squares
    const Node& all = levels_.back().front();
    const float length = std::sqrt(static_cast<float>(distance)) +
                         kPlaces * static_cast<float>(std::max(all.right, all.top));
    return length * length * kProducts;
}

// By the sites of these leaves. The leaf's own sites are shifted by (x, y). Hardly any site has
// another one so near. Single precision finds most of them without a branch for each leaf; for the
// others, integers decide.
LACUNA_WIDE void SiteTree::lower_by_leaves(std::size_t leaf, std::int64_t x, std::int64_t y,
                                           std::span<const std::size_t> leaves,
                                           std::span<std::uint64_t> nearest) const {
    using Floats [[gnu::vector_size(kFan * sizeof(float))]] = float;
    Rounded own = rounded_[leaf];
    for (std::size_t i = leaf * kFan; i < children_end(0, leaf); ++i) {
        const std::int64_t at_x = sites_[i].x + x;
        const std::int64_t at_y = sites_[i].y + y;
        std::uint64_t& least = nearest[i % kFan];
        const float reach = rounded_reach(least);
        const auto rounded_x = static_cast<float>(at_x), rounded_y = static_cast<float>(at_y);
        // A site is no neighbour of itself.
        const float its_x = std::exchange(own.x[i % kFan], std::numeric_limits<float>::infinity());
        auto are_near = Floats{} < Floats{};  // all bits of a number, or none
        for (const std::size_t other : leaves) {
            const Rounded& sites = other == leaf ? own : rounded_[other];
            Floats dx, dy;
            std::memcpy(&dx, sites.x.data(), sizeof dx);
            std::memcpy(&dy, sites.y.data(), sizeof dy);
            dx -= rounded_x;
            dy -= rounded_y;
            are_near |= dx * dx + dy * dy < reach;
        }
        own.x[i % kFan] = its_x;
        std::array<std::uint64_t, sizeof are_near / sizeof(std::uint64_t)> bits{};
        std::memcpy(bits.data(), &are_near, sizeof are_near);
        if ((bits[0] | bits[1] | bits[2] | bits[3]) == 0) continue;
        for (const std::size_t other : leaves)
            for (std::size_t j = other * kFan; j < children_end(0, other); ++j)
                if (j != i)
                    least = std::min(least, squared(sites_[j].x - at_x, sites_[j].y - at_y));
    }
}

// Grows `kept` if it must, and returns its part with the nodes that are near.
std::span<const std::size_t> SiteTree::keep_near(std::size_t level, const Rectangle& box,
                                                 std::uint64_t distance,
                                                 std::span<const std::size_t> nodes,
                                                 std::vector<std::size_t>& kept) const {
    if (kept.size() < nodes.size()) kept.resize(nodes.size());
    std::size_t count = 0;
    for (const std::size_t node : nodes) {
        kept[count] = node;
        count += std::size_t{squared_gap(levels_[level][node], box) < distance};
    }
    return std::span(kept).first(count);
}

// The leaves that are nearer to the rectangle than `distance`, squared: a part of near.of_block.
std::span<const std::size_t> SiteTree::find_leaves(const Rectangle& box, std::uint64_t distance,
                                                   Neighbours& near) const {
    near.children.assign(1, 0);
    for (std::size_t level = levels_.size() - 1;; --level) {
        const auto found = keep_near(level, box, distance, near.children, near.of_block);
        if (level == 0) return found;
        near.children.clear();
        for (const std::size_t node : found)
            for (std::size_t child = node * kFan; child < children_end(level, node); ++child)
                near.children.push_back(child);
    }
}

}  // namespace lacuna::relaxing::cpu

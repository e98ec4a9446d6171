// Finds the sites that can win a box of lattice points, with a tree of rectangles around near
// sites. Each node has the least weight in it, so that a large weight has only local effect.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/workers.h"
#include "lattice/lattice.h"

namespace lacuna::relaxing::cpu {

// A rectangle, both ends included. Signed, because images on a torus lie outside the domain.
struct Rectangle {
    std::int64_t left;
    std::int64_t right;
    std::int64_t bottom;
    std::int64_t top;
};

class SiteTree {
public:
    // Builds the tree over at least one site, in an order in which near sites are near each other.
    // The sites must outlive the tree. After they move, call it again.
    void look_at(std::span<const Site> sites, Workers& workers);

    // Each site has a power in the rectangle's worst corner. Returns the least of these, or `bound`
    // if that is less.
    std::uint64_t least_worst_power(const Rectangle& box, std::uint64_t bound) const;

    // Calls found(site) for every site whose power is at most `bound` somewhere in the rectangle,
    // and for some others.
    template <typename Found>
    void find(const Rectangle& box, std::uint64_t bound, Found found) const {
        find_below(levels_.size() - 1, 0, box, bound, found);
    }

    // Sites [kBlock i, kBlock (i + 1)), as far as they exist, are block i.
    static constexpr std::size_t kBlock = 64;

    // Lists of leaves of the tree, reused from block to block.
    struct Neighbours {
        std::vector<std::size_t> children;
        std::vector<std::size_t> of_block;
        std::vector<std::size_t> of_leaf;
    };
    // Lowers nearest[i] to the squared distance of the block's i-th site to the nearest other site,
    // or to an image of it, if that is less. Only positions are read of sites.
    void lower_to_nearest(std::size_t block, std::int64_t period_x, std::int64_t period_y,
                          Neighbours& near, std::span<std::uint64_t, kBlock> nearest) const;

private:
    static constexpr std::size_t kFan = 8;
    struct Node {
        std::uint32_t left;
        std::uint32_t right;
        std::uint32_t bottom;
        std::uint32_t top;
        std::uint64_t least_weight;
    };

    // The rounded places of a leaf's sites; infinite where there is no site.
    struct Rounded {
        std::array<float, kFan> x;
        std::array<float, kFan> y;
    };

    static std::uint64_t gap(std::int64_t low, std::int64_t high, std::int64_t begin,
                             std::int64_t end) {
        return static_cast<std::uint64_t>(
            std::max(std::max(low - end, begin - high), std::int64_t{0}));
    }
    static std::uint64_t squared(std::int64_t dx, std::int64_t dy) {
        return static_cast<std::uint64_t>(dx * dx + dy * dy);
    }
    static std::uint64_t squared_gap(const Node& node, const Rectangle& box) {
        const std::uint64_t dx = gap(node.left, node.right, box.left, box.right);
        const std::uint64_t dy = gap(node.bottom, node.top, box.bottom, box.top);
        return dx * dx + dy * dy;
    }
    static Rectangle moved(const Node& node, std::int64_t x, std::int64_t y) {
        return {node.left + x, node.right + x, node.bottom + y, node.top + y};
    }
    static std::uint64_t least_power(const Node& node, const Rectangle& box) {
        return squared_gap(node, box) + node.least_weight;
    }
    static std::uint64_t least_power(const Site& site, const Rectangle& box) {
        return least_power(Node{site.x, site.x, site.y, site.y, site.weight}, box);
    }

    // Level 0 has the nodes above the sites; the last level has one node.
    std::size_t children_end(std::size_t level, std::size_t node) const {
        const std::size_t below = level == 0 ? sites_.size() : levels_[level - 1].size();
        return std::min((node + 1) * kFan, below);
    }

    template <typename Found>
    void find_below(std::size_t level, std::size_t node, const Rectangle& box, std::uint64_t bound,
                    Found& found) const {
        if (least_power(levels_[level][node], box) > bound) return;
        const std::size_t end = children_end(level, node);
        for (std::size_t child = node * kFan; child < end; ++child) {
            if (level != 0)
                find_below(level - 1, child, box, bound, found);
            else if (least_power(sites_[child], box) <= bound)
                found(static_cast<std::uint32_t>(child));
        }
    }

    void round_sites_of(std::size_t leaf);
    void lower_by_leaves(std::size_t leaf, std::int64_t x, std::int64_t y,
                         std::span<const std::size_t> leaves,
                         std::span<std::uint64_t> nearest) const;
    float rounded_reach(std::uint64_t distance) const;
    // Copies the nodes that are nearer to the rectangle than `distance`, which is squared.
    std::span<const std::size_t> keep_near(std::size_t level, const Rectangle& box,
                                           std::uint64_t distance,
                                           std::span<const std::size_t> nodes,
                                           std::vector<std::size_t>& kept) const;
    std::span<const std::size_t> find_leaves(const Rectangle& box, std::uint64_t distance,
                                             Neighbours& near) const;

    // The power of a site in the rectangle's worst corner.
    static std::uint64_t worst_power(const Site& site, const Rectangle& box);
    void lower_worst_power(std::size_t level, std::size_t node, const Rectangle& box,
                           std::uint64_t& bound) const;

    std::span<const Site> sites_;
    std::vector<std::vector<Node>> levels_;
    std::vector<Rounded> rounded_;  // of each leaf
};

}  // namespace lacuna::relaxing::cpu

// Finds the sites that can win a box of lattice points, with a tree of rectangles around near
// sites. Each node has the least weight in it, so that a large weight has only local effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/workers.h"
#include "relax/lattice.h"

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

private:
    static constexpr std::size_t kFan = 8;

    struct Node {
        std::uint32_t left;
        std::uint32_t right;
        std::uint32_t bottom;
        std::uint32_t top;
        std::uint64_t least_weight;
    };

    static std::uint64_t gap(std::int64_t low, std::int64_t high, std::int64_t begin,
                             std::int64_t end) {
        return static_cast<std::uint64_t>(low > end ? low - end : begin > high ? begin - high : 0);
    }
    static std::uint64_t least_power(const Node& node, const Rectangle& box) {
        const std::uint64_t dx = gap(node.left, node.right, box.left, box.right);
        const std::uint64_t dy = gap(node.bottom, node.top, box.bottom, box.top);
        return dx * dx + dy * dy + node.least_weight;
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
    // The power of a site in the rectangle's worst corner.
    static std::uint64_t worst_power(const Site& site, const Rectangle& box);
    void lower_worst_power(std::size_t level, std::size_t node, const Rectangle& box,
                           std::uint64_t& bound) const;

    std::span<const Site> sites_;
    std::vector<std::vector<Node>> levels_;
};

}  // namespace lacuna::relaxing::cpu

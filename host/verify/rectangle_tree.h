// A tree of the rectangles around things, which finds those near a place without looking at all.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

#include "verify/cell.h"

namespace lacuna::verify {

inline double squared_distance_to(const Cell& cell, Point place) {
    const double dx = std::max({cell.left - place.x, 0.0, place.x - cell.right});
    const double dy = std::max({cell.bottom - place.y, 0.0, place.y - cell.top});
    return square(dx) + square(dy);
}

inline double squared_distance_between(const Cell& a, const Cell& b) {
    const double dx = std::max({a.left - b.right, 0.0, b.left - a.right});
    const double dy = std::max({a.bottom - b.top, 0.0, b.bottom - a.top});
    return square(dx) + square(dy);
}

// It is built by halving the longer side of the rectangle around all.
class RectangleTree {
public:
    // Brings the items into the order of the tree, which knows them by their numbers.
    template <typename Item, typename RectangleOf>
    RectangleTree(std::vector<Item>& items, RectangleOf rectangle_of) {
        if (items.empty()) return;
        // Each node halves its items, so the depth of the tree is log2 of the number of leaves.
        nodes_.resize(4 * std::bit_ceil((items.size() + kFewItems - 1) / kFewItems));
        build(0, 0, items.size(), items, rectangle_of);
    }

    // Around all items, of which there must be one at least.
    const Cell& around() const { return nodes_.front().around; }

    // Calls use(number) for the items of all leaves that enters(rectangle) lets pass, as it does
    // the rectangles around them.
    template <typename Enters, typename Use>
    void visit(Enters enters, Use use) const {
        OpenNodes open;
        if (!nodes_.empty()) open.push(0);
        while (!open.is_empty()) {
            const std::size_t index = open.pop();
            const Node& node = nodes_[index];
            if (!enters(node.around)) continue;
            if (node.is_leaf()) {
                for (std::size_t i = node.begin; i < node.end; ++i) use(i);
                continue;
            }
            open.push(2 * index + 1);
            open.push(2 * index + 2);
        }
    }

    // The smallest to_item(number), or infinity if there is none. For items in a rectangle,
    // to_node(rectangle) is a lower bound.
    template <typename ToNode, typename ToItem>
    double least(ToNode to_node, ToItem to_item) const {
        double least = std::numeric_limits<double>::infinity();
        OpenNodes open;
        if (!nodes_.empty()) open.push(0);
        while (!open.is_empty()) {
            const std::size_t index = open.pop();
            const Node& node = nodes_[index];
            if (to_node(node.around) >= least) continue;
            if (node.is_leaf()) {
                for (std::size_t i = node.begin; i < node.end; ++i)
                    least = std::min(least, to_item(i));
                continue;
            }
            const std::size_t low = 2 * index + 1;
            const std::size_t high = 2 * index + 2;
            const bool is_high_nearer = to_node(nodes_[high].around) < to_node(nodes_[low].around);
            // The nearer half is looked at first.
            open.push(is_high_nearer ? low : high);
            open.push(is_high_nearer ? high : low);
        }
        return least;
    }

private:
    // A node holds the items in [begin, end). Node i has its halves in nodes 2 i + 1 and 2 i + 2.
    struct Node {
        Cell around;
        std::size_t begin;
        std::size_t end;

        bool is_leaf() const { return end - begin <= kFewItems; }
    };
    static constexpr std::size_t kFewItems = 4;

    // The nodes that are still to be visited. There are never more of them than the tree is deep.
    class OpenNodes {
    public:
        void push(std::size_t node) { nodes_[count_++] = node; }
        std::size_t pop() { return nodes_[--count_]; }
        bool is_empty() const { return count_ == 0; }

    private:
        std::array<std::size_t, 128> nodes_;
        std::size_t count_ = 0;
    };

    template <typename Item, typename RectangleOf>
    void build(std::size_t node, std::size_t begin, std::size_t end, std::vector<Item>& items,
               RectangleOf rectangle_of) {
        Cell around = rectangle_of(items[begin]);
        for (std::size_t i = begin + 1; i < end; ++i) {
            const Cell one = rectangle_of(items[i]);
            around = {std::min(around.left, one.left), std::max(around.right, one.right),
                      std::min(around.bottom, one.bottom), std::max(around.top, one.top)};
        }
        nodes_[node] = {around, begin, end};
        if (nodes_[node].is_leaf()) return;
        const bool is_wide = around.right - around.left >= around.top - around.bottom;
        const auto middle_of = [&](const Item& item) {
            const Cell one = rectangle_of(item);
            return is_wide ? one.left + one.right : one.bottom + one.top;
        };
        const std::size_t half = begin + (end - begin + 1) / 2;
        const auto at = [&](std::size_t i) {
            return items.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(begin), at(half), at(end),
                         [&](const Item& a, const Item& b) { return middle_of(a) < middle_of(b); });
        build(2 * node + 1, begin, half, items, rectangle_of);
        build(2 * node + 2, half, end, items, rectangle_of);
    }

    std::vector<Node> nodes_;
};

}  // namespace lacuna::verify

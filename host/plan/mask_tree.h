// A mask as a tree of squares of pixels. Squares whose pixels are alike are not cut further, so the
// memory is in proportion to the length of the outline, whatever the extent of the page.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/polling.h"
#include "plan/pixels.h"
#include "portable/mask_tree.h"

namespace lacuna {

// Pixels are counted from the lower left corner of the domain.
class MaskTree {
public:
    struct Node {
        std::uint32_t values;
        std::uint32_t first;
    };
    // A square of pixels: whether none, some or all of them are allowed; if some, its node.
    struct Piece {
        std::uint32_t value = ALLOWED_NONE;
        Node node{};
    };
    static constexpr std::size_t kSlots = 16;

    MaskTree(std::uint32_t columns, std::uint32_t rows);
    explicit MaskTree(const Mask& mask, const Poll& poll = nobody_asks);

    // A tree of which each pixel is cut into `split` equal ones along an axis, with pixels before
    // and behind those on which no sample may lie.
    struct Padding {
        std::uint32_t split = 1;
        std::uint32_t before = 0;
        std::uint32_t behind = 0;
    };
    MaskTree(const MaskTree& inner, const Padding& across, const Padding& up, const Poll& poll);

    std::uint32_t columns() const { return columns_; }
    std::uint32_t rows() const { return rows_; }
    // The slots of the root are 2^root pixels wide.
    unsigned root() const { return root_; }
    const std::vector<Node>& nodes() const { return nodes_; }

    // To build a tree: the piece of a node whose slots are 2^shift pixels wide, and which has the
    // pixel (column, row) in its lower left corner. Slots beyond the mask do not count.
    Piece join(unsigned shift, std::uint32_t column, std::uint32_t row,
               std::array<Piece, kSlots>& slots);
    void set_root(const Piece& root);

    // What at() and over() of a Pyramid (plan/pixels.h) would say.
    std::uint8_t at(std::uint32_t column, std::uint32_t row) const {
        Place at{0, root_};
        std::uint32_t slot = portable::slot_of(column, row, at.shift);
        while (portable::value_of_slot(nodes_[at.node].values, slot) == ALLOWED_SOME) {
            at = child(at, slot);
            slot = portable::slot_of(column, row, at.shift);
        }
        return static_cast<std::uint8_t>(portable::value_of_slot(nodes_[at.node].values, slot));
    }
    std::uint8_t over(PixelRange columns, PixelRange rows) const;

    // Calls visit(column, row, columns, rows) for rectangles of pixels that do not overlap, and
    // together are all allowed pixels.
    using Visit = std::function<void(std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t)>;
    void for_each_allowed(const Visit& visit) const;
    double allowed_share() const;  // of all pixels

private:
    struct Place {
        std::uint32_t node;
        unsigned shift;
    };

    // value_of(column, row, side) is the value of a square; if it is ALLOWED_SOME, the square is
    // cut further.
    template <class ValueOf>
    Piece build(unsigned shift, std::uint32_t column, std::uint32_t row, const ValueOf& value_of,
                const Poll& poll);
    Place child(Place at, std::uint32_t slot) const {
        const Node& node = nodes_[at.node];
        return {node.first + portable::rank_of_slot(node.values, slot), at.shift - 2};
    }
    // Adds the values of the squares of 2^level pixels that the range touches, all of which lie in
    // the node, until there are two. Bit v of `values` is for the value v.
    void add_values(Place at, unsigned level, PixelRange columns, PixelRange rows,
                    std::uint32_t& values) const;
    void visit_node(Place at, std::uint32_t column, std::uint32_t row, const Visit& visit) const;

    std::uint32_t columns_;
    std::uint32_t rows_;
    unsigned root_ = 0;
    std::vector<Node> nodes_{{}};  // the first one is the root
    std::size_t joined_ = 0;
};

// A mask that was drawn: Mask::drawn has it. What is said of points does not depend on pixels.
struct DrawnMask {
    MaskTree tree;
    std::function<bool(Point)> holds;  // whether samples may lie at a position
    std::function<bool(Point)> keeps;  // likewise kept points, which may also lie on outlines
};

}  // namespace lacuna

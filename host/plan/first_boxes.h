// The first boxes of a plan with a radius field. They contain every position where a sample may
// lie, and are not much longer than the least radius under them. Also the tree of cuts, from the
// domain down to blocks of a few boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/pixels.h"
#include "plan/plan.h"

namespace lacuna {

struct FirstBoxes {
    // A box of the tree. A node comes before its parts.
    struct Node {
        Box box;
        std::uint32_t greatest;  // the largest radius under it
        std::uint32_t next;      // the first node after this one and its parts
        std::uint32_t first;     // the first block in it
        std::uint32_t whole;     // the node of which it is a part, or itself
    };
    // A few boxes that together are not much longer than one: each block has a list of samples.
    struct Block {
        std::uint32_t first;        // the first of its boxes
        std::uint32_t even_radius;  // the radius, if it is the same under all of the block, or 0
        std::uint32_t node;
    };

    std::vector<Box> boxes;
    std::vector<Block> blocks;  // the last entry only marks the end of the boxes
    std::vector<Node> nodes;    // nodes without parts belong to blocks

    std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks.size()) - 1; }
    // Calls visit(box, block) with the numbers of all boxes from the first of `block` up to `end`.
    template <typename Visit>
    void for_each_box(std::uint32_t block, std::uint32_t end, Visit visit) const {
        for (std::uint32_t box = blocks[block].first; box < end; ++box) {
            if (box == blocks[block + 1].first) ++block;
            visit(box, block);
        }
    }

    // Nodes that do not overlap and together contain all boxes; each is a unit of work for threads.
    // `begins` has the first box of each, then the number of boxes.
    std::vector<std::uint32_t> regions;
    std::vector<std::uint32_t> begins;
};

FirstBoxes first_boxes(const Plan& plan);

}  // namespace lacuna

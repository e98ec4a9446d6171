// The places of a plan with a radius field before the first sample: rectangles that hold all that
// is allowed, not much longer than the least radius under them; and the tree of cuts that led to
// blocks of a few of them.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/pixels.h"
#include "plan/plan.h"

namespace lacuna {

struct FirstBoxes {
    // What was cut, each before its parts.
    struct Node {
        Rectangle place;
        std::uint32_t greatest;  // radius under it
        std::uint32_t next;      // the first node after it and its parts
        std::uint32_t first;     // of the blocks in it
        std::uint32_t whole;     // the node that it is a part of, or itself
    };
    // A few places, not much longer together than one: what samples are listed for.
    struct Block {
        std::uint32_t first;        // of its places
        std::uint32_t even_radius;  // the one under all of it, or 0
        std::uint32_t node;
    };

    std::vector<Rectangle> places;
    std::vector<Block> blocks;  // and one past the last, where the places end
    std::vector<Node> nodes;    // those without parts are those of blocks

    std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks.size()) - 1; }
    // Calls visit(place, block), by number, for places from the first of `block` up to `end`.
    template <typename Visit>
    void for_each_place(std::uint32_t block, std::uint32_t end, Visit visit) const {
        for (std::uint32_t place = blocks[block].first; place < end; ++place) {
            if (place == blocks[block + 1].first) ++block;
            visit(place, block);
        }
    }

    // Nodes that do not overlap and hold all places, to share out the work by; and the first place
    // in each, then the number of places.
    std::vector<std::uint32_t> regions;
    std::vector<std::uint32_t> begins;
};

FirstBoxes first_boxes(const Plan& plan);

}  // namespace lacuna

// The first boxes of a plan with a radius field. They contain every position where a sample may
// lie, and are not much longer than the least radius under them. Also the tree of cuts, from the
// domain down to blocks of a few boxes.
#pragma once

#include <cstdint>
#include <memory>
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
        std::uint32_t least;  // the least radius under it
    };

    std::vector<Box> boxes;
    std::vector<Block> blocks;  // the last entry only marks the end of the boxes
    std::vector<Node> nodes;    // nodes without parts belong to blocks
    // The node of each copy (plan/class_copies.h) whose class is drawn, in the order of the
    // classes. With one class it is node 0, the domain; with several the copies are the parts of
    // node 0.
    std::vector<std::uint32_t> copies;

    std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks.size()) - 1; }
    // Calls visit(box, block) with the numbers of all boxes from the first of `block` up to `end`.
    template <typename Visit>
    void for_each_box(std::uint32_t block, std::uint32_t end, Visit visit) const {
        for (std::uint32_t box = blocks[block].first; box < end; ++box) {
            if (box == blocks[block + 1].first) ++block;
            visit(box, block);
        }
    }

    // The number of parts of each node. One without parts, which belongs to a block, has 1.
    std::vector<std::uint32_t> part_counts() const;

    // Nodes that do not overlap and together contain all boxes; each is a unit of work for threads.
    // `begins` has the first box of each, then the number of boxes.
    std::vector<std::uint32_t> regions;
    std::vector<std::uint32_t> begins;

    // A part of the domain on all copies: its node on each copy, and the regions in it. With one
    // class a zone is a region. A sample whose disk lies in a zone changes nothing in another.
    struct Zone {
        std::vector<std::uint32_t> nodes;
        std::vector<std::uint32_t> regions;
    };
    std::vector<Zone> zones;
};

// Of each class, where it may lie: a radius field with its border and mask. The boxes on its copy
// are cut along both, so that the plan's radius field needs neither. Empty: all classes may lie
// where the plan's radius field says.
using PlacesOfClasses = std::vector<std::shared_ptr<const RadiusField>>;

FirstBoxes first_boxes(const Plan& plan, const PlacesOfClasses& places = {});

}  // namespace lacuna

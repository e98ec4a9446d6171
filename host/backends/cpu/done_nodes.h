// Which nodes of the tree of first boxes (plan/first_boxes.h) have no block left to visit.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "plan/first_boxes.h"

namespace lacuna::cpu {

// Threads may call finish() and undo() at the same time for blocks of different zones: these share
// the nodes above the zones. is_done() is for nodes in the zone of the thread.
class DoneNodes {
public:
    // From here on no node is done.
    void begin(const FirstBoxes& first) {
        first_ = &first;
        parts_left_ = first.part_counts();
    }
    // Always false before begin().
    bool is_done(std::uint32_t node) const {
        return !parts_left_.empty() && parts_left_[node] == 0;
    }
    // The block is done, and was not; or it is not done any more.
    void finish(std::uint32_t block) {
        std::uint32_t node = node_of(block);
        while (part(node).fetch_sub(1, std::memory_order_relaxed) == 1 && node != 0)
            node = first_->nodes[node].whole;
    }
    void undo(std::uint32_t block) {
        std::uint32_t node = node_of(block);
        while (part(node).fetch_add(1, std::memory_order_relaxed) == 0 && node != 0)
            node = first_->nodes[node].whole;
    }
    bool has_begun() const { return !parts_left_.empty(); }

private:
    std::uint32_t node_of(std::uint32_t block) const { return first_->blocks[block].node; }
    std::atomic_ref<std::uint32_t> part(std::uint32_t node) {
        return std::atomic_ref(parts_left_[node]);
    }

    const FirstBoxes* first_ = nullptr;
    std::vector<std::uint32_t> parts_left_;  // of each node; a block's node has 1 until it is done
};

}  // namespace lacuna::cpu

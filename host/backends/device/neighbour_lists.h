// Neighbour lists on a device: with a radius field, the samples that reach each block of first
// boxes (plan/first_boxes.h). reach.h in kernels/bodies/exact finds the blocks, enlist.h adds
// samples.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/device/round_memory.h"
#include "plan/first_boxes.h"

namespace lacuna::device {

class NeighbourLists {
public:
    // Makes room for the tables. Call put() before the first round.
    explicit NeighbourLists(RoundMemory& round);

    // Replaces the samples in the lists by these, as if they were a round's admitted candidates.
    // Waits.
    void put(std::span<const Sized> samples);
    // All samples; some are in several lists. Waits.
    std::vector<Sample> get() const;

    void begin_part() { listed_ = Listed::none; }
    // For rounds of one part: empties the list of survivors, which screen fills and reach serves.
    void begin_survivors();
    // Lists the part's candidates as visitors of the blocks that they reach, and makes room for
    // them in the lists of samples. Waits. Further calls for the same part do nothing.
    void list_visitors();
    // Queues adding the admitted visitors to the lists.
    void enlist();

    // The first entry of a sample that has not cut the boxes yet.
    std::uint32_t first_recent() const { return first_recent_; }
    void end_round();

private:
    enum class Listed { none, survivors, visitors };  // of the open part

    std::uint32_t blocks() const { return first_.block_count(); }
    std::uint32_t entries() const { return entries_before_ + round_.report[ENTRIES_WORD]; }
    bool may_visit_many() const;
    void make_tree();

    RoundMemory& round_;
    const FirstBoxes& first_;
    std::uint32_t entries_before_ = 0;  // before the round
    std::uint32_t first_recent_ = 0;
    Listed listed_ = Listed::none;
    bool visits_all_at_once_;  // the nodes that a candidate reaches
};

}  // namespace lacuna::device

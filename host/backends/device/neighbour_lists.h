// The samples with a radius field, listed on a device for each block of first boxes that they reach
// (plan/first_boxes.h): kernels/bodies/exact/reach.h finds those, enlist.h lists the samples.
#pragma once

#include <array>
#include <cstdint>

#include "backends/device/round_memory.h"
#include "plan/first_boxes.h"

namespace lacuna::device {

class NeighbourLists {
public:
    explicit NeighbourLists(RoundMemory& round);

    // As if they were candidates of a round, all of them admitted.
    void enlist_kept();

    void begin_part() { has_visitors_ = false; }
    // Of a round in one part, screen lists the survivors, and those alone reach blocks.
    bool has_survivors() const { return round_.parts() == 1; }
    void begin_survivors();
    bool has_visitors() const { return has_visitors_; }
    // Lists the part's candidates for the blocks that they reach, and makes room for them in the
    // lists of samples. Waits in between.
    void list_visitors();
    // Queues this: those of them that were admitted are listed for good. A part without candidates
    // left has no visitors.
    void enlist();

    void start_download();
    // From here on entries are of samples that have not cut the places yet.
    std::uint32_t first_recent() const { return first_recent_; }
    void end_round() { first_recent_ = entry_count_.front(); }

private:
    std::uint32_t blocks() const { return first_.block_count(); }
    void make_tree();
    void make_room_for_entries(std::uint64_t count);

    RoundMemory& round_;
    const FirstBoxes& first_;
    std::array<std::uint32_t, 1> entry_count_{};
    std::uint32_t first_recent_ = 0;
    bool has_visitors_ = false;
};

}  // namespace lacuna::device

// Neighbour lists on a device: with a radius field, the samples that reach each block of first
// boxes (plan/first_boxes.h). reach.h in kernels/bodies/exact finds the blocks, enlist.h adds
// samples.
#pragma once

#include <array>
#include <cstdint>

#include "backends/device/round_memory.h"
#include "plan/first_boxes.h"

namespace lacuna::device {

class NeighbourLists {
public:
    explicit NeighbourLists(RoundMemory& round);

    // Lists the kept samples, as if they were the admitted candidates of a round.
    void enlist_kept();

    void begin_part() { has_visitors_ = false; }
    // If the round has one part, screen lists the survivors, and reach serves only these.
    bool has_survivors() const { return round_.parts() == 1; }
    void begin_survivors();
    bool has_visitors() const { return has_visitors_; }
    // Lists the part's candidates for the blocks that they reach, which makes them visitors there,
    // and makes room for them in the lists of samples. Waits in between.
    void list_visitors();
    // Queues adding the admitted visitors to the lists. A part without open candidates has none.
    void enlist();

    void start_download();
    // The first entry of a sample that has not cut the boxes yet.
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

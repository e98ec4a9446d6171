// The sample grid of mode exact on a device: the neighbour index where there is one radius.
#pragma once

#include <cstdint>

#include "backends/backend.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

class Grid {
public:
    explicit Grid(RoundMemory& round);

    // Queues this: candidates of the whole round that samples of earlier rounds cover.
    void screen();
    // Candidates of the open part and those up to `end` that samples of earlier parts cover.
    void screen_again(std::uint32_t end);
    // The samples of the part, into the grid.
    void insert();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    RoundMemory& round_;
};

}  // namespace lacuna::device

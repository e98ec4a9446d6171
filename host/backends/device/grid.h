// The sample grid of mode exact on a device: the neighbour index where there is one radius.
#pragma once

#include <cstdint>

#include "backends/backend.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

class Grid {
public:
    explicit Grid(RoundMemory& round);

    // Queues the search for the round's candidates that samples of earlier rounds cover.
    void screen();
    // The same for samples of earlier parts: candidates from the open part's begin to `end`.
    void screen_again(std::uint32_t end);
    // Queues putting the part's samples into the grid.
    void insert();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    RoundMemory& round_;
};

}  // namespace lacuna::device

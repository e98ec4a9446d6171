// The sample grid of mode exact on a device: the neighbour index where there is one radius.
#pragma once

#include <cstdint>

#include "backends/backend.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

class Grid {
public:
    explicit Grid(RoundMemory& round);

    // Queues the search for candidates that samples in the grid cover: see Bins::screen.
    void screen(Range draws, std::uint32_t status);
    // Queues putting the part's samples into the grid.
    void insert();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    RoundMemory& round_;
};

}  // namespace lacuna::device

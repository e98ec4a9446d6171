// The sample grid of modes lines and exact on a device: the neighbour index where there is one
// radius. Its cells list the round's candidates, too.
#pragma once

#include <cstdint>

#include "backends/backend.h"
#include "backends/device/round_memory.h"

namespace lacuna::device {

class Grid {
public:
    explicit Grid(RoundMemory& round);

    // Queues the search for candidates that samples in the grid cover; with `opens`, also lists the
    // candidates in their cells. See Bins::screen.
    void screen(Range draws, std::uint32_t status, bool opens);
    // Queues putting the part's samples into the grid. The lists of its cells are empty afterwards.
    // With `marks`, new_cells[] has the cells of these samples.
    void insert(bool marks);
    // Queues unmarking all cells.
    void begin_new_cells();

    void snapshot(Snapshot& snapshot);
    void restore(const Snapshot& snapshot);

private:
    std::uint64_t cells() const;
    std::uint64_t words() const;  // of new_cells[]
    void empty_lists();

    RoundMemory& round_;
    bool lists_candidates_ = false;
};

}  // namespace lacuna::device

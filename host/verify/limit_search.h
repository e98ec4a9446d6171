// One thread's part of the search for the barest spot.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/cell.h"
#include "verify/emptiest_by_limit.h"
#include "verify/ground.h"
#include "verify/patience.h"

namespace lacuna::verify {

// What is asked of all spots.
struct Limits {
    const Ground& ground;
    double tolerance;  // so far over its limit a spot is as good as covered
    double finest;     // what is barer by less is not worth looking for
    double rounding;   // the most by which a distance may be off
    const Patience& patience;
};

class LimitSearch {
public:
    LimitSearch(const Limits& limits, const BareSpot& start) : limits_(limits), barest_(start) {}

    // The barest spot of the cell that was looked at, if barer than the start; see
    // emptiest_by_limit.
    BareSpot run(const Cell& cell, const Under& under, std::vector<Disk> disks);

private:
    // The disks that matter to the cell are on the stack from `begin` on.
    void visit(const Cell& cell, const Under& outer, std::size_t begin);
    // Sees whether the cell's centre is barer than the barest. The index of the disk that covers it
    // best.
    std::size_t look_from(Point centre, const Under& under, std::size_t begin);
    // A cell of which no spot is farther over its limit needs no cutting.
    double settled_from() const;

    const Limits& limits_;
    BareSpot barest_;
    std::uint32_t visits_ = 0;
    std::vector<Disk> stack_;  // the disks of each cell from the first to the one visited
};

}  // namespace lacuna::verify

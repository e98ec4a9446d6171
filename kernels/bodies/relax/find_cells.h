// The body of find_cells: counts the samples of each cell, and ranks them within it. The order
// within a cell may be any: sums of whole numbers do not depend on it.
#include "bodies/relax/cell_of.h"

BODY void serve_find_cells(MEMORY const DescentArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.domain.samples);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const Mover mover = LOAD(Mover, movers, i);
        AT(ranks, i) = ATOMIC_ADD(counts, cell_of(a, mover.x, mover.y), 1u);
    }
}

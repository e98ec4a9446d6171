// The body of insert: puts the round's samples into the sample grid, and empties the lists of
// candidates in its cells. Does nothing while admission is unfinished (report[last_pass] != 0).
#include "bodies/lines/place.h"
#include "portable/bits.h"

// If a.is_listed is set, a bit of new_cells[] is set for each sample: 32 rows of a column of cells
// have one word.
BODY void serve_insert(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const u32 status = AT(statuses, i);
        if (status == STATUS_COVERED) continue;  // it was never listed
        const Candidate candidate = LOAD(Candidate, candidates, i);
        const u32 cell = cell_of_candidate(a.g, candidate);
        AT(cell_heads, cell) = NO_SAMPLE;
        if (status != STATUS_ADMITTED) continue;
        AT(grid_x, cell) = candidate.x;
        AT(grid_y, cell) = candidate.y;
        if (a.is_listed == 0u) continue;
        const u32 column = cell / a.g.grid_rows;
        const u32 row = cell % a.g.grid_rows;
        ATOMIC_OR(new_cells, column * words_of_column(a.g.grid_rows) + row / 32u, 1u << row % 32u);
    }
}

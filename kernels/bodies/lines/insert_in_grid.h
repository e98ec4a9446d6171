// Puts a sample into its cell of the sample grid, whose candidates are a list.
#include "bodies/lines/place.h"
#include "portable/bits.h"

BODY u32 list_of(const DrawArguments a, const Candidate candidate) {
    return cell_of_candidate(a.g, candidate);
}

// If a.is_listed is set, a bit of new_cells[] is set for each sample: 32 rows of a column of cells
// have one word.
BODY void insert_sample(MEMORY const DrawArguments a, const u32 i, const Candidate candidate,
                        const u32 cell) {
    AT(grid_x, cell) = candidate.x;
    AT(grid_y, cell) = candidate.y;
    if (a.is_listed == 0u) return;
    const u32 column = cell / a.g.grid_rows;
    const u32 row = cell % a.g.grid_rows;
    ATOMIC_OR(new_cells, column * words_of_column(a.g.grid_rows) + row / 32u, 1u << row % 32u);
}

// What screen asks in lines and exact: whether a sample in the grid covers a candidate.
#include "bodies/lines/place.h"
#include "portable/distance.h"
#include "portable/stretch.h"

// 1 if the cell has a sample closer than the radius, else 0. Returns a number, because compilers
// keep branches for truth values.
BODY u32 is_covered_from(MEMORY const Geometry g, const u32 cell, const u32 x, const u32 y,
                         const u32 period_x, const u32 period_y) {
    const u32 sample_x = AT(grid_x, cell);
    const bool is_near =
        are_closer(sample_x, AT(grid_y, cell), x, y, period_x, period_y, g.radius_squared);
    return (is_near ? 1u : 0u) & (sample_x != NO_SAMPLE ? 1u : 0u);
}

// In exact a disk that touches no edge lies within 4 x 4 cells, because it is 2 sqrt(2) < 3 cells
// wide.
// There is no branch, because neighbouring items, which run in lockstep, look at different places.
BODY bool is_covered_inside(MEMORY const Geometry g, const u32 x, const u32 y) {
    const u32 column = min((x - g.radius) / g.grid_side, g.grid_columns - 4u);
    const u32 row = min((y - g.radius) / g.grid_side, g.grid_rows - 4u);
    u32 covered = 0u;
    for (u32 i = 0u; i < 4u; ++i) {
        const u32 first = (column + i) * g.grid_rows + row;
        for (u32 j = 0u; j < 4u; ++j)
            covered = covered | is_covered_from(ON g, first + j, x, y, 0u, 0u);
    }
    return covered != 0u;
}

// Whether a sample in the grid is closer than the radius.
BODY bool is_covered(MEMORY const DrawArguments a, const u32 i) {
    const Geometry g = a.g;
    const u32 x = place_of(a, LOAD(Candidate, candidates, i));
    const u32 y = LOAD(Candidate, candidates, i).y;
    if (g.rule != RULE_OF_LINES && min(g.grid_columns, g.grid_rows) >= 4u &&
        g.radius < min(g.width, g.height) && min(x, y) >= g.radius && x < g.width - g.radius &&
        y < g.height - g.radius)
        return is_covered_inside(ON g, x, y);
    const Stretch columns =
        cells_near(x, x + 1u, g.radius, g.width, g.period_x, g.grid_side, g.grid_columns);
    const Stretch rows =
        cells_near(y, y + 1u, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    u32 covered = 0u;
    for (u32 k = 0u; k < columns.count; ++k) {
        const u32 column = nth_of_stretch(columns, k, g.grid_columns) * g.grid_rows;
        for (u32 j = 0u; j < rows.count && covered == 0u; ++j)
            covered = is_covered_from(ON g, column + nth_of_stretch(rows, j, g.grid_rows), x, y,
                                      g.period_x, g.period_y);
    }
    return covered != 0u;
}

// Lists the candidate in its cell, for decide. A restored round may have admitted it before.
BODY void leave_open(MEMORY const DrawArguments a, const u32 i) {
    if (a.is_listed == 0u || AT(statuses, i) > STATUS_ADMITTED) return;
    const u32 cell = cell_of_candidate(a.g, LOAD(Candidate, candidates, i));
    AT(next_candidates, i) = ATOMIC_SET(cell_heads, cell, i);
}

// Searches the cells of the sample grid nearby for an earlier sample of the round that conflicts
// with a candidate. cell_heads[] has the first candidate of the round in each cell, and
// next_candidates[] the next one in the cell of each candidate.
#include "bodies/lines/place.h"
#include "portable/distance.h"
#include "portable/stretch.h"

// What the candidates in one cell decide about a candidate, added to what others have decided:
// whether an earlier one rejects it, or may still reject it, and how many were looked at.
struct Decided {
    bool is_rejected;
    bool waits;
    u32 looks;
};
LACUNA_TYPEDEF(Decided)

BODY Decided decide_by_cell(MEMORY const Geometry g, const Decided before, const u32 head,
                            const u32 x, const u32 y, const u32 order) {
    Decided all = before;
    for (u32 i = head; i != NO_SAMPLE && !all.is_rejected; i = AT(next_candidates, i)) {
        ++all.looks;
        const Candidate other = LOAD(Candidate, candidates, i);
        if (other.order >= order) continue;
        if (!are_closer(other.x, other.y, x, y, g.period_x, g.period_y, g.radius_squared)) continue;
        // An admitted candidate rejects this one; an undecided one may reject it later.
        const u32 status = ATOMIC_OR(statuses, i, 0u);
        all.is_rejected = status == STATUS_ADMITTED;
        all.waits = all.waits || status == STATUS_UNDECIDED;
    }
    return all;
}

// The status of a candidate as far as it can be decided now, plus four times the number of others
// looked at. Items of one pass read statuses that other items are writing; whatever they read, a
// decided status is final.
BODY u32 decide(MEMORY const DrawArguments a, const u32 i, const Candidate candidate) {
    const Geometry g = a.g;
    const u32 x = place_of(a, candidate);
    const u32 y = candidate.y;
    const Stretch columns =
        cells_near(x, x + 1u, g.radius, g.width, g.period_x, g.grid_side, g.grid_columns);
    const Stretch rows =
        cells_near(y, y + 1u, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    Decided decided = {false, false, 0u};
    for (u32 k = 0u; k < columns.count && !decided.is_rejected; ++k) {
        const u32 column = nth_of_stretch(columns, k, g.grid_columns) * g.grid_rows;
        for (u32 j = 0u; j < rows.count; ++j) {
            const u32 head = AT(cell_heads, column + nth_of_stretch(rows, j, g.grid_rows));
            if (head != NO_SAMPLE)
                decided = decide_by_cell(ON g, decided, head, x, y, candidate.order);
        }
    }
    if (decided.is_rejected) return STATUS_REJECTED + 4u * decided.looks;
    return (decided.waits ? STATUS_UNDECIDED : STATUS_ADMITTED) + 4u * decided.looks;
}

// The conflict rule of lines and exact: limit and reach are the radius.
#include "portable/column.h"

// In lines the chord on the candidate's own line counts, so its x is the x of the line.
BODY u32 place_of(const DrawArguments a, const u32x4 candidate) {
    const u32 middle = candidate.z * a.g.strip_width + a.g.strip_width / 2u;
    return a.g.rule != RULE_OF_LINES ? candidate.x : middle;
}

BODY u32 reach_of(MEMORY const DrawArguments a, const u32x4 candidate) {
    return a.g.radius;
}

BODY Stretch columns_near(const DrawArguments a, const u32x4 candidate, const u32 reach) {
    const u32 column = column_of_line(candidate.z, a.g.lines, a.g.columns);
    return stretch_around(column, 1u, a.g.columns, a.g.period_x);
}

// The square of the distance that candidates i and j must keep.
BODY u64 limit_of(MEMORY const DrawArguments a, const u32 i, const u32 j) {
    return a.g.radius_squared;
}

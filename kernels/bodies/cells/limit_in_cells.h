// The conflict rule of mode cells: the limit is the metric of two radii (section 4.2.1). The reach
// of a pixel is the largest distance of a conflict with a sample on it.
#include "portable/column.h"
#include "portable/metric.h"

BODY u32 place_of(const DrawArguments a, const Candidate candidate) {
    return candidate.x;
}

BODY u32 reach_of(MEMORY const DrawArguments a, const Candidate candidate) {
    return AT(pixel_reaches, AT(column_of, candidate.x) * a.rows + AT(row_of, candidate.y));
}

BODY Stretch columns_near(const DrawArguments a, const Candidate candidate, const u32 reach) {
    const Stretch lines = stretch_around(candidate.x, reach, a.g.lines, a.g.period_x);
    return columns_of_stretch(lines, a.g.lines, a.g.columns);
}

// The square of the distance that candidates i and j must keep.
BODY u64 limit_of(MEMORY const DrawArguments a, const u32 i, const u32 j) {
    return metric_squared(
        twice_metric_radius(a.metric, AT(candidate_radii, i), AT(candidate_radii, j)));
}

// Ellipses where a field stretches disks (portable/ellipse.h), from the tables `axes` and
// `ellipses`. Only where the rule is RULE_OF_ELLIPSES are the tables filled.
#ifndef LACUNA_BODIES_ELLIPSES_H
#define LACUNA_BODIES_ELLIPSES_H
#include "bodies/exact/factor.h"
#include "bodies/exact/pixels.h"
#include "portable/conflict.h"

BODY Ellipse ellipse_at(MEMORY const u32 x, const u32 y) {
    const PixelGrid field = grid_of(ON COLUMNS_OF_FIELD);
    const u32 pixel = pixel_of(field.columns, x) * field.rows.pixels + pixel_of(field.rows, y);
    return LOAD(Ellipse, ellipses, pixel);
}

// Whether a sample or candidate at x, y conflicts with another one.
BODY bool are_in_conflict(MEMORY const Geometry g, const u32 x, const u32 y, const u32 radius,
                          const Sized one) {
    const Sized other = {x_beside(x, one.x, g.copy_bits), y, radius};
    if (!conflicts(other, one, factor_of(ON g, x, one.x), g.period_x, g.period_y)) return false;
    if (g.rule != RULE_OF_ELLIPSES) return true;
    return ellipses_conflict(other, ellipse_at(ON x, y), one, ellipse_at(ON one.x, one.y),
                             g.period_x, g.period_y);
}

#endif

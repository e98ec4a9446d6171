// The body of split: finds where to cut boxes on unlike pixels into four strips
// (bodies/exact/strip.h) when they are halved. Comes after radius_field.h. Does nothing while a
// draw is undecided.

// The y at which a border of pixels cuts a half, or the half's end if none does, and the least
// radii below and above that y, 0 where no sample may lie.
struct Cut {
    u32 y;
    u32 below;
    u32 above;
};
LACUNA_TYPEDEF(Cut)

BODY u32 radius_in(MEMORY const Grids grids, const Box part) {
    return radius_under(under(ON grids, touched_by(grids, part)));
}

BODY Cut cut_of(MEMORY const Grids grids, const Box part) {
    Cut cut = {part.end, 0u, 0u};
    if (part.width == 0u) return cut;
    const Touched touched = touched_by(grids, part);
    const Under all = under(ON grids, touched);
    const u32 y = cut_y(grids, touched, all);
    cut.below = radius_under(all);
    if (y == 0u) return cut;
    const Box below = {part.x, part.width, part.begin, y};
    const Box above = {part.x, part.width, y, part.end};
    cut.y = y;
    cut.below = radius_in(ON grids, below);
    cut.above = radius_in(ON grids, above);
    return cut;
}

// Writes borders[] and strip_radii[] of boxes that are not even.
BODY void serve_split(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (number < end && (LOAD(Origin, origins, number).radius & IS_EVEN) != 0u) ++number;
        if (number == end) break;
        const Box box = LOAD(Box, boxes, number);
        const Touched touched = touched_by(grids, box);
        const u32 cut = cut_x(grids, box, touched, under(ON grids, touched));
        const u32 x = cut == 0u ? box.x + box.width : cut;
        const Box left_half = {box.x, x - box.x, box.begin, box.end};
        const Box right_half = {x, box.x + box.width - x, box.begin, box.end};
        const Cut left = cut_of(ON grids, left_half);
        const Cut right = cut_of(ON grids, right_half);
        const Borders lines = {x, left.y, right.y, 0u};
        const StripRadii radii = {left.below, left.above, right.below, right.above};
        STORE(borders, number, lines);
        STORE(strip_radii, number, radii);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

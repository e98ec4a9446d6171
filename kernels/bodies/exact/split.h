// The body of split: finds where to cut boxes on unlike pixels into four strips
// (bodies/exact/strip.h) when they are halved. Comes after radius_field.h. Does nothing while a
// draw is undecided.

// The y at which a border of pixels cuts a half, or the half's end if none does; then the least
// radii below and above that y, 0 where no sample may lie.
BODY u32x4 borders_in(MEMORY const Grids grids, const u32x4 part) {
    if (part.y == 0u) return U32X4(part.w, 0u, 0u, 0u);
    const Touched touched = touched_by(grids, part);
    const Under all = under(ON grids, touched);
    const u32 y = cut_y(grids, touched, all);
    if (y == 0u) return U32X4(part.w, radius_under(all), 0u, 0u);
    return U32X4(
        y, radius_under(under(ON grids, touched_by(grids, U32X4(part.x, part.y, part.z, y)))),
        radius_under(under(ON grids, touched_by(grids, U32X4(part.x, part.y, y, part.w)))), 0u);
}

// borders[box] becomes the x between its halves, and the y that cuts each half; strip_radii[box]
// becomes the least radius of each strip, perhaps with IS_EVEN.
BODY void serve_split(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (number < end && (AT(origins, number).y & IS_EVEN) != 0u) ++number;
        if (number == end) break;
        const u32x4 box = AT(boxes, number);
        const Touched touched = touched_by(grids, box);
        const u32 cut = cut_x(grids, box, touched, under(ON grids, touched));
        const u32 x = cut == 0u ? box.x + box.y : cut;
        const u32x4 left = borders_in(ON grids, U32X4(box.x, x - box.x, box.z, box.w));
        const u32x4 right = borders_in(ON grids, U32X4(x, box.x + box.y - x, box.z, box.w));
        AT(borders, number) = U32X4(x, left.x, right.x, 0u);
        AT(strip_radii, number) = U32X4(left.y, left.z, right.y, right.z);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The body of split: halves the places of a radius field that lie on unlike pixels along x, and
// cuts the halves along y where a border of pixels runs through them: four strips a place (see
// strip.h). Comes after radius_field.h.

// Empty where no sample may go: then its radius is 0.
BODY void put_strip(MEMORY const u32 number, const u32x4 at, const u32 radius) {
    AT(strips, number) = U32X4(at.x, at.y, at.z, radius != 0u ? at.w : at.z);
    AT(strip_radii, number) = radius;
}

BODY void put_half(MEMORY const Grids grids, const u32 number, const u32x4 part,
                   const Touched touched) {
    const Under all = under(ON grids, touched);
    const u32 up = cut_y(ON grids, touched, all);
    u32x4 low = part;
    u32x4 high = part;
    u32x2 radii = U32X2(radius_under(all), 0u);
    if (up != 0u) {
        low.w = up;
        high.z = up;
        radii = U32X2(radius_under(under(ON grids, touched_below(grids, touched, up))),
                      radius_under(under(ON grids, touched_above(grids, touched, up))));
    }
    put_strip(ON number, low, radii.x);
    put_strip(ON number + 1u, high, radii.y);
}

BODY void serve_split(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32x4 place = AT(places, AT(uneven, i));
        const Touched touched = touched_by(grids, place);
        const u32 cut = cut_x(ON grids, place, touched, under(ON grids, touched));
        u32x4 left = place;
        Touched by_left = touched;
        if (cut != 0u) {
            left.y = cut - place.x;
            by_left = touched_left(grids, touched, cut);
        }
        put_half(ON grids, i * 4u, left, by_left);
        if (cut != 0u) {
            put_half(ON grids, i * 4u + 2u, U32X4(cut, place.x + place.y - cut, place.z, place.w),
                     touched_right(grids, touched, cut));
        } else {
            put_strip(ON i * 4u + 2u, place, 0u);
            put_strip(ON i * 4u + 3u, place, 0u);
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The body of split: where to halve the boxes that lie on unlike pixels. borders[box] becomes the x
// of the border between its halves, and the y of a border of pixels in the left half and in the
// right one; 0 where there is none. Comes after radius_field.h. Does nothing while admission is
// unsettled.

BODY u32 border_in(MEMORY const Grids grids, const Touched touched) {
    return cut_y(ON grids, touched, under(ON grids, touched));
}

BODY void serve_split(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        if ((AT(origins, number).y & IS_EVEN) != 0u) continue;
        const u32x4 box = AT(boxes, number);
        const Touched touched = touched_by(grids, box);
        const u32 x = cut_x(ON grids, box, touched, under(ON grids, touched));
        const Touched left = x == 0u ? touched : touched_left(grids, touched, x);
        const u32 up_right = x == 0u ? 0u : border_in(ON grids, touched_right(grids, touched, x));
        AT(borders, number) = U32X4(x, border_in(ON grids, left), up_right, 0u);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

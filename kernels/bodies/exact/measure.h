// The body of measure: finds the least radius under each new box where keep did not know it. Comes
// after radius_field.h. Does nothing while a draw is undecided: then there are no new boxes.

BODY void serve_measure(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 end = min((item + 1u) * a.chunk, min(a.room, AT(total, 0)));
    for (u32 number = item * a.chunk; number < end; ++number) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (number < end && AT(new_origins, number).y != 0u) ++number;
        if (number == end) break;
        const u32 radius = radius_under(under(ON grids, touched_by(grids, AT(new_boxes, number))));
        AT(new_origins, number) = U32X2(AT(new_origins, number).x, radius);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

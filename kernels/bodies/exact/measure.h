// The body of measure: finds the least radius under each new box where keep did not know it, and
// writes the lengths of all new boxes to results[], then their widths. Comes after radius_field.h.
// Does nothing while a draw is undecided: then there are no new boxes.

BODY void serve_measure(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 boxes = AT(report, TOTAL_WORD) - AT(report, SAMPLES_WORD);
    const u32 end = min((item + 1u) * a.chunk, min(a.room, boxes));
    for (u32 number = item * a.chunk; number < end && boxes <= a.room; ++number) {
        const u32x4 box = AT(new_boxes, number);
        AT(results, number) = box.w - box.z;
        AT(results, boxes + number) = box.y;
    }
    for (u32 number = item * a.chunk; number < end; ++number) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (number < end && AT(new_origins, number).y != 0u) ++number;
        if (number == end) break;
        const u32 radius = radius_under(under(ON grids, touched_by(grids, AT(new_boxes, number))));
        AT(new_origins, number) = U32X2(AT(new_origins, number).x, radius);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

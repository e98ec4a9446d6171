// The body of measure: finds the least radius under each new box where keep did not know it, and
// writes the lengths of all new boxes to results[], then their widths. Comes after radius_field.h.
// Does nothing while a draw is undecided: then there are no new boxes.

BODY void serve_measure(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    const u32 boxes = AT(report, TOTAL_WORD) - AT(report, SAMPLES_WORD);
    const u32 end = min((item + 1u) * a.chunk, min(a.room, boxes));
    for (u32 number = item * a.chunk; number < end && boxes <= a.room; ++number) {
        const Box box = LOAD(Box, new_boxes, number);
        AT(results, number) = box.end - box.begin;
        AT(results, boxes + number) = box.width;
    }
    for (u32 number = item * a.chunk; number < end; ++number) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (number < end && LOAD(Origin, new_origins, number).radius != 0u) ++number;
        if (number == end) break;
        const Touched touched = touched_by(grids, LOAD(Box, new_boxes, number));
        Origin origin = LOAD(Origin, new_origins, number);
        origin.radius = radius_under(under(ON grids, touched));
        STORE(new_origins, number, origin);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

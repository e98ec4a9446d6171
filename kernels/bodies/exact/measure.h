// The body of measure: the least radius under each of the uneven new places where it is not known
// yet. Comes after radius_field.h. Item i serves number i of them, i + chunk and so on. Does
// nothing while admission is unsettled: then there are no new places.

BODY void serve_measure(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u || item >= a.chunk) return;
    const u32 end = AT(list_counts, OF_NEW_UNEVEN);
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    for (u32 i = item; i < end; i += a.chunk) {
        const u32 number = AT(new_uneven, i);
        if (AT(new_origins, number).y == 0u)
            AT(new_origins, number).y =
                radius_under(under(ON grids, touched_by(grids, AT(new_places, number))));
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

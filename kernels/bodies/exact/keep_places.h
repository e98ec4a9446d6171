// The body of keep_places: writes what cut_places left to the new places. Comes after kept_piece.h.
// Does nothing while admission is unsettled.

BODY void serve_keep_places(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x4 cut = AT(pieces, number);
        if (cut.y == 0u) continue;
        const u32x2 origin = AT(origins, number);
        keep_rest(ON a, whole_strip(AT(places, number), origin.y), origin.x, U32X2(cut.x, cut.y),
                  U32X2(cut.z, cut.w), place_of_first(ON a, number));
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The bodies of keep_places and keep_halves: write what was cut to the new places. Come after
// kept_piece.h. Do nothing while admission is unsettled.

BODY void keep_all(MEMORY const StripArguments a, const bool is_halved, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 strips = strips_of_place(is_halved);
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x4 place = AT(places, number);
        const u32x2 origin = AT(origins, number);
        u32 to = place_of_first(ON a, number);
        const bool is_here = AT(pieces, number * strips).y != NO_SAMPLE;
        for (u32 k = 0u; k < strips; ++k) {
            const u32x2 piece = AT(pieces, number * strips + k);
            if (!is_here || piece.y == 0u) continue;
            const Strip strip = strip_of(ON is_halved, number, place, origin.y, k);
            keep_piece(ON a, strip, origin.x, piece, to);
            ++to;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

BODY void serve_keep_places(MEMORY const StripArguments a, const u32 item) {
    keep_all(ON a, false, item);
}

BODY void serve_keep_halves(MEMORY const StripArguments a, const u32 item) {
    keep_all(ON a, true, item);
}

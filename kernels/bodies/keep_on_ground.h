// The body of keep on a ground: writes what cut left to the new places. Comes after kept_piece.h.
// Does nothing while admission is unsettled.

BODY void serve_keep_on_ground(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x2 piece = AT(pieces, number);
        if (piece.y != 0u && piece.y != NO_SAMPLE)
            keep_piece(ON a, number, piece, place_of_first(ON a, number));
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

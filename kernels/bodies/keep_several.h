// The body of keep_several: cuts the strips of cut_several once more, and writes what is left of
// them to the new places. Comes after remnants.h and kept_piece.h. Does nothing while admission is
// unsettled.

BODY void serve_keep_several(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u || item >= a.chunk) return;
    const u32 end = AT(several_count, 0);
    for (u32 k = item; k < end; k += a.chunk) {
        const u32 number = AT(several, k);
        const Strip strip = strip_of(ON number);
        const Rest rest = rest_of(ON a, strip);
        u32 to = place_of_first(ON a, number);
        u32x2 piece = U32X2(rest.low, rest.low);
        while (piece.y < rest.high) {
            piece = next_piece(ON a, strip, rest, piece.y);
            if (piece.x < piece.y) keep_piece(ON a, number, piece, to);
            ++to;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The body of keep on a ground: writes what cut left to the new places. Comes after remnants.h.

// The least radius under a piece is that of its strip, if the piece is all of it, or of its first
// place, if that is even; else it is not known. What does not fit into the room is left out: the
// host sees the total, and asks again.
BODY void keep_piece(MEMORY const StripArguments a, const u32 number, const u32x2 piece,
                     const u32 to) {
    if (to >= a.room) return;
    const u32x4 strip = AT(places, number);
    const u32x2 origin = AT(origins, number);
    const bool is_whole = piece.x == strip.z && piece.y == strip.w;
    AT(new_places, to) = U32X4(strip.x, strip.y, piece.x, piece.y);
    AT(new_origins, to) = U32X2(origin.x, is_whole ? origin.y : AT(lists, origin.x).y);
}

// A strip's pieces go to counts[strip] + sums[strip / block] and on. Only a strip with several is
// cut once more. Does nothing while admission is unsettled.
BODY void serve_keep_on_ground(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        u32x2 piece = AT(pieces, number);
        u32 to = AT(counts, number) + AT(sums, number / a.block);
        if (piece.y != 0u && piece.y != NO_SAMPLE) keep_piece(ON a, number, piece, to);
        if (piece.y != NO_SAMPLE) continue;
        const Strip strip = strip_of(ON number);
        const Rest rest = rest_of(ON a, strip);
        piece = U32X2(rest.low, rest.low);
        while (piece.y < rest.high) {
            piece = next_piece(ON a, strip, rest, piece.y);
            if (piece.x < piece.y) keep_piece(ON a, number, piece, to);
            ++to;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

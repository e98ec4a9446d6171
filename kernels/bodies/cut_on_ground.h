// The body of cut on a ground: cuts places, or their parts, by the samples listed for them. Comes
// after remnants.h.

// counts[strip] is how many pieces are left of a strip, and pieces[strip] the piece where there is
// one; an end of 0 tells of none, NO_SAMPLE of several. Does nothing while admission is unsettled.
BODY void serve_cut_on_ground(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const Strip strip = strip_of(ON number);
        const Rest rest = rest_of(ON a, strip);
        u32 count = 0u;
        u32x2 first = U32X2(0u, 0u);
        u32x2 piece = U32X2(rest.low, rest.low);
        while (piece.y < rest.high) {
            piece = next_piece(ON a, strip, rest, piece.y);
            if (piece.x == piece.y) break;
            if (count == 0u) first = piece;
            ++count;
        }
        if (count > 1u) first.y = NO_SAMPLE;
        AT(counts, number) = count;
        AT(pieces, number) = first;
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The body of cut_several: how many pieces are left of each strip that chords cut inside. Comes
// after remnants.h. Item i serves number i of them, i + chunk and so on. Does nothing while
// admission is unsettled.

BODY void serve_cut_several(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u || item >= a.chunk) return;
    const u32 end = AT(several_count, 0);
    for (u32 k = item; k < end; k += a.chunk) {
        const u32 number = AT(several, k);
        const Strip strip = strip_of(ON number);
        const Rest rest = rest_of(ON a, strip);
        u32 count = 0u;
        u32x2 piece = U32X2(rest.low, rest.low);
        while (piece.y < rest.high) {
            piece = next_piece(ON a, strip, rest, piece.y);
            if (piece.x < piece.y) ++count;
        }
        AT(counts, number) = count;
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

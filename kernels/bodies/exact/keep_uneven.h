// The body of keep_uneven: writes what cut_uneven left to the new places. Comes after kept_piece.h
// and uneven_strip.h. Does nothing while admission is unsettled.

BODY void serve_keep_uneven(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32 number = AT(uneven, i);
        const u32 block = AT(origins, number).x;
        const u32x4 left = AT(pieces, number);
        const u32x4 right = AT(more_pieces, number);
        const u32x2 nothing = U32X2(0u, 0u);
        u32 to = place_of_first(ON a, number);
        to = keep_rest(ON a, uneven_strip(ON i, 0u), block, U32X2(left.x, left.y), nothing, to);
        to = keep_rest(ON a, uneven_strip(ON i, 1u), block, U32X2(left.z, left.w), nothing, to);
        to = keep_rest(ON a, uneven_strip(ON i, 2u), block, U32X2(right.x, right.y), nothing, to);
        keep_rest(ON a, uneven_strip(ON i, 3u), block, U32X2(right.z, right.w), nothing, to);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

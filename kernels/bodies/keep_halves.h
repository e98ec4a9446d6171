// The body of keep_halves: writes what cut_halves left to the new places. Comes after kept_piece.h.
// Does nothing while admission is unsettled.

// The number of the new place after those of this half.
BODY u32 keep_half(MEMORY const StripArguments a, const Strip strip, const u32 block,
                   const u32x2 left, const u32x2 inside, const u32 first) {
    const bool has_inside = (left.y & IS_CUT_INSIDE) != 0u;
    const u32 end = left.y & ~IS_CUT_INSIDE;
    u32x2 piece = U32X2(left.x, has_inside ? inside.x : end);
    u32 to = first;
    while (true) {
        put_place(ON a, strip, block, piece, strip.radius, to);
        ++to;
        if (piece.y == end) break;
        piece = U32X2(inside.y, end);
    }
    return to;
}

BODY void serve_keep_halves(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x2 origin = AT(origins, number);
        const u32x4 left = AT(pieces, number);
        if (!is_even(origin.y) || (left.y == 0u && left.w == 0u)) continue;
        const u32x4 place = AT(places, number);
        u32x4 insides = U32X4(0u, 0u, 0u, 0u);
        if (((left.y | left.w) & IS_CUT_INSIDE) != 0u) insides = AT(more_pieces, number);
        u32 to = place_of_first(ON a, number);
        if (left.y != 0u)
            to = keep_half(ON a, left_half(place, origin.y), origin.x, U32X2(left.x, left.y),
                           U32X2(insides.x, insides.y), to);
        if (left.w != 0u)
            keep_half(ON a, right_half(place, origin.y), origin.x, U32X2(left.z, left.w),
                      U32X2(insides.z, insides.w), to);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

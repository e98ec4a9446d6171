// The body of keep_halves: writes what cut_halves left to the new places. Comes after kept_piece.h.
// Does nothing while admission is unsettled.

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
        const u32 second = keep_rest(ON a, left_half(place, origin.y), origin.x,
                                     U32X2(left.x, left.y & ~IS_CUT_INSIDE),
                                     U32X2(insides.x, insides.y), place_of_first(ON a, number));
        keep_rest(ON a, right_half(place, origin.y), origin.x,
                  U32X2(left.z, left.w & ~IS_CUT_INSIDE), U32X2(insides.z, insides.w), second);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

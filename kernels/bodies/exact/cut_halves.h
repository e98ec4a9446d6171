// The body of cut_halves: cuts the halves of each place by the samples listed for it. Places on
// unlike pixels are left to cut_uneven. Comes after touches.h. Does nothing while admission is
// unsettled.

BODY u32 flag_of(const u32x2 inside) {
    return inside.y != 0u ? IS_CUT_INSIDE : 0u;
}

BODY void serve_cut_halves(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x2 origin = AT(origins, number);
        if (!is_even(origin.y)) continue;
        const u32x4 place = AT(places, number);
        const Strip left = left_half(place, origin.y);
        const Strip right = right_half(place, origin.y);
        const BothTouches touches =
            touches_of(ON a, pair_of_one(left), true, pair_of_one(right), origin.x);
        const Cut of_left = cut_strip(a, left, touches.left);
        const Cut of_right = cut_strip(a, right, touches.right);
        AT(counts, number) = of_left.count + of_right.count;
        put_pieces(ON number, 0u,
                   U32X4(of_left.piece.x, of_left.piece.y | flag_of(of_left.inside),
                         of_right.piece.x, of_right.piece.y | flag_of(of_right.inside)),
                   of_left.may_be_several || of_right.may_be_several);
        if (of_left.inside.y + of_right.inside.y != 0u)
            AT(more_pieces, number) =
                U32X4(of_left.inside.x, of_left.inside.y, of_right.inside.x, of_right.inside.y);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

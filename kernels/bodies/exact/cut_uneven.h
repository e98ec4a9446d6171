// The body of cut_uneven: cuts the strips of places on unlike pixels by the samples listed for
// them. Comes after touches.h and uneven_strip.h. Does nothing while admission is unsettled.

BODY bool may_be_two(const Cut cut) {
    return cut.may_be_several || cut.count > 1u;
}

BODY void serve_cut_uneven(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32 number = AT(uneven, i);
        const Strip left_low = uneven_strip(ON i, 0u);
        const Strip left_high = uneven_strip(ON i, 1u);
        const Strip right_low = uneven_strip(ON i, 2u);
        const Strip right_high = uneven_strip(ON i, 3u);
        const BothTouches touches =
            touches_of(ON a, pair_of(left_low, left_high), true, pair_of(right_low, right_high),
                       AT(origins, number).x);
        const Cut first = cut_strip(a, left_low, touches.left);
        const Cut second = cut_strip(a, left_high, touches.left);
        const Cut third = cut_strip(a, right_low, touches.right);
        const Cut fourth = cut_strip(a, right_high, touches.right);
        const bool may_be_several =
            may_be_two(first) || may_be_two(second) || may_be_two(third) || may_be_two(fourth);
        AT(counts, number) = first.count + second.count + third.count + fourth.count;
        put_pieces(ON number, i,
                   U32X4(first.piece.x, first.piece.y, second.piece.x, second.piece.y),
                   may_be_several);
        AT(more_pieces, number) =
            may_be_several ? U32X4(0u, 0u, 0u, 0u)
                           : U32X4(third.piece.x, third.piece.y, fourth.piece.x, fourth.piece.y);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

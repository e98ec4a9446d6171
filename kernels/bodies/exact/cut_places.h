// The body of cut_places: cuts each place by the samples listed for it. Comes after touches.h. Does
// nothing while admission is unsettled.

BODY void serve_cut_places(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x2 origin = AT(origins, number);
        const Strip strip = whole_strip(AT(places, number), origin.y);
        const Pair all = pair_of_one(strip);
        const Cut cut = cut_strip(a, strip, touches_of(ON a, all, false, all, origin.x).left);
        AT(counts, number) = cut.count;
        put_pieces(ON number, 0u, U32X4(cut.piece.x, cut.piece.y, cut.inside.x, cut.inside.y),
                   cut.may_be_several);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

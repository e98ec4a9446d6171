// The body of keep_several: cuts the places of cut_several once more, and writes what is left of
// them to the new places. Comes after several.h and kept_piece.h. While admission is unsettled
// there are none.

BODY void serve_keep_several(MEMORY const StripArguments a, const u32 item) {
    if (item >= a.chunk) return;
    const u32 end = AT(list_counts, OF_SEVERAL);
    for (u32 i = item; i < end; i += a.chunk) {
        const u32 number = AT(several, i).x;
        const u32x4 place = AT(places, number);
        const u32x2 origin = AT(origins, number);
        const u32 list = AT(lists, origin.x);
        u32 to = place_of_first(ON a, number);
        const bool is_halved = a.is_halved != 0u;
        for (u32 k = 0u; k < strips_of_place(is_halved, origin.y); ++k) {
            const Strip strip = strip_of(ON is_halved, AT(several, i).y, place, origin.y, k);
            const Rest rest = rest_of(ON a, strip, list);
            u32x2 piece = U32X2(rest.low, rest.low);
            while (piece.y < rest.high) {
                piece = next_piece(ON a, strip, list, rest, piece.y);
                if (piece.x >= piece.y) continue;
                keep_piece(ON a, strip, origin.x, piece, to);
                ++to;
            }
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

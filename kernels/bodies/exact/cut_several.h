// The body of cut_several: how many pieces are left of each place that the others left to it.
// Comes after several.h. Item i serves number i of them, i + chunk and so on. While admission is
// unsettled there are none.

BODY void serve_cut_several(MEMORY const StripArguments a, const u32 item) {
    if (item >= a.chunk) return;
    const u32 end = AT(list_counts, OF_SEVERAL);
    for (u32 i = item; i < end; i += a.chunk) {
        const u32 number = AT(several, i).x;
        const u32x4 place = AT(places, number);
        const u32x2 origin = AT(origins, number);
        const u32 list = AT(lists, origin.x);
        u32 count = 0u;
        const bool is_halved = a.is_halved != 0u;
        for (u32 k = 0u; k < strips_of_place(is_halved, origin.y); ++k) {
            const Strip strip = strip_of(ON is_halved, AT(several, i).y, place, origin.y, k);
            const Rest rest = rest_of(ON a, strip, list);
            u32x2 piece = U32X2(rest.low, rest.low);
            while (piece.y < rest.high) {
                piece = next_piece(ON a, strip, list, rest, piece.y);
                if (piece.x < piece.y) ++count;
            }
        }
        AT(counts, number) = count;
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

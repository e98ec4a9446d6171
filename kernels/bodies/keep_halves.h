// The body of keep_halves: writes what cut_halves left to the new places. Comes after kept_piece.h.
// Does nothing while admission is unsettled.

BODY void serve_keep_halves(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32x2 origin = AT(origins, number);
        const u32x4 both = AT(pieces, number);
        if (!is_even(origin.y) || (both.y == 0u && both.w == 0u)) continue;
        const u32x4 place = AT(places, number);
        const u32 first = place_of_first(ON a, number);
        const u32 second = both.y == 0u ? first : first + 1u;
        if (both.y != 0u)
            put_place(ON a, left_half(place, origin.y), origin.x, U32X2(both.x, both.y), origin.y,
                      first);
        if (both.w != 0u)
            put_place(ON a, right_half(place, origin.y), origin.x, U32X2(both.z, both.w), origin.y,
                      second);
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

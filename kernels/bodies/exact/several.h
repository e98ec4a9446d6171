// All that the samples listed for a place leave of a strip of it, piece by piece, for cut_several
// and keep_several. Comes after remnants.h and uneven_strip.h.

BODY u32 strips_of_place(const bool is_halved, const u32 radius) {
    if (!is_halved) return 1u;
    return is_even(radius) ? 2u : 4u;
}

// `uneven` is where in uneven[] the place is, if it lies on unlike pixels.
BODY Strip strip_of(MEMORY const bool is_halved, const u32 uneven, const u32x4 place,
                    const u32 radius, const u32 k) {
    if (!is_halved) return whole_strip(place, radius);
    if (!is_even(radius)) return uneven_strip(ON uneven, k);
    if (k == 0u) return left_half(place, radius);
    return right_half(place, radius);
}

BODY Rest rest_of(MEMORY const StripArguments a, const Strip strip, const u32 list) {
    Rest rest = all_of(strip);
    u32 number = list;
    while (is_in_list(a, number) && rest.low < rest.high) {
        const u32x4 entry = AT(entries, number);
        number = entry.w;
        rest =
            without_sample(a, strip, rest, cut_distance(a.g, strip.at, entry.x), entry.y, entry.z);
    }
    return rest;
}

// The lowest piece of the rest that begins at `from` or above: [x, y); empty if there is none.
BODY u32x2 next_piece(MEMORY const StripArguments a, const Strip strip, const u32 list,
                      const Rest rest, const u32 from) {
    const u32 windows = a.g.period_y != 0u ? 3u : 1u;
    u32 begin = from;
    while (begin < rest.high) {
        // Chords that cover `begin` move it up; else the lowest one above it ends the piece.
        u32 end = rest.high;
        bool has_moved = false;
        u32 number = rest.insides != 0u ? list : NO_SAMPLE;
        while (is_in_list(a, number)) {
            const u32x4 entry = AT(entries, number);
            number = entry.w;
            const u32 reach = sized_reach(strip, cut_distance(a.g, strip.at, entry.x), entry.z);
            for (u32 window = 0u; window < windows; ++window) {
                const u32 chord_begin = window_begin(window, entry.y, reach, a.g.height);
                const u32 chord_end = window_end(window, entry.y, reach, a.g.height);
                if (chord_begin >= chord_end || chord_end <= begin || chord_begin >= end) continue;
                has_moved = has_moved || chord_begin <= begin;
                begin = chord_begin <= begin ? chord_end : begin;
                end = chord_begin > begin ? chord_begin : end;
            }
        }
        if (!has_moved) return U32X2(begin, end);
    }
    return U32X2(rest.high, rest.high);
}

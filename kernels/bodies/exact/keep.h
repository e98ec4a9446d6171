// The body of keep: writes what cut left to the new boxes. Comes after strips.h.

// What does not fit into the room is left out: the host sees the total, and asks again.
BODY void keep_piece(MEMORY const StripArguments a, const u32 x, const u32x2 piece,
                     const u32 place) {
    if (place >= a.room) return;
    AT(new_x, place) = x;
    AT(new_begin, place) = piece.x;
    AT(new_end, place) = piece.y;
    AT(free_lengths, place) = piece.y - piece.x;
}

// A strip's pieces go to counts[strip] + sums[strip / block] and on. Only a strip with several is
// cut once more. Does nothing while admission is unsettled.
BODY void serve_keep(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end_strip = min((item + 1u) * a.chunk, a.boxes << a.is_halved);
    for (u32 index = item * a.chunk; index < end_strip; ++index) {
        const u32 end = AT(piece_end, index);
        u32 place = AT(counts, index) + AT(sums, index >> a.block_bits);
        if (end != 0u && end != NO_SAMPLE) {
            const u32 x = AT(box_x, index >> a.is_halved) + (index & a.is_halved) * a.width;
            keep_piece(ON a, x, U32X2(AT(piece_begin, index), end), place);
        }
        if (end != NO_SAMPLE) continue;
        const Strip box = box_at(ON a, index >> a.is_halved);
        const Near near = near_of(ON a.g, box);
        const Strip strip = part_of(a, box, index & a.is_halved);
        const Rest rest = cut_strip(ON a.g, near, strip);
        u32x2 piece = U32X2(rest.low, rest.low);
        while (piece.y < rest.high) {
            piece = next_piece(ON a.g, near, strip, rest, piece.y);
            if (piece.x < piece.y) keep_piece(ON a, strip.x, piece, place);
            ++place;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

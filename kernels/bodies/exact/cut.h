// The body of cut: cuts the strips of all boxes by all samples near them. Comes after strips.h.

// What is not cut stays one piece, however wide strips are now.
BODY void keep_whole(MEMORY const StripArguments a, const u32 number, const Strip box) {
    const u32 first = number << a.is_halved;
    AT(counts, first + a.is_halved) = 0u;
    AT(piece_end, first + a.is_halved) = 0u;
    AT(counts, first) = 1u;
    AT(piece_begin, first) = box.begin;
    AT(piece_end, first) = box.end;
}

// counts[strip] is how many pieces are left of a strip, and [piece_begin, piece_end) the piece
// where there is one; an end of 0 tells of none, NO_SAMPLE of several. Does nothing while admission
// is unsettled.
BODY void serve_cut(MEMORY const StripArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end_box = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end_box; ++number) {
        const Strip box = box_at(ON a, number);
        if (box.x - a.own_begin >= a.own_width) {
            keep_whole(ON a, number, box);
            continue;
        }
        const Near near = near_of(ON a.g, box);
        for (u32 part = 0u; part <= a.is_halved; ++part) {
            const Strip strip = part_of(a, box, part);
            const Rest rest = cut_strip(ON a.g, near, strip);
            u32 count = 0u;
            u32x2 first = U32X2(0u, 0u);
            u32x2 piece = U32X2(rest.low, rest.low);
            while (piece.y < rest.high) {
                piece = next_piece(ON a.g, near, strip, rest, piece.y);
                if (piece.x == piece.y) break;
                if (count == 0u) first = piece;
                ++count;
            }
            const u32 index = (number << a.is_halved) + part;
            AT(counts, index) = count;
            AT(piece_begin, index) = first.x;
            AT(piece_end, index) = count > 1u ? NO_SAMPLE : first.y;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

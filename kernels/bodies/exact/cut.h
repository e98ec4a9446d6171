// The body of cut: cuts each box, strip by strip, by all samples near it, and counts the pieces.
// Comes after pieces.h.

// counts[box] becomes the number of its pieces. strip_pieces[] has an entry for each strip,
// 2^strip_bits for a box: [x, y) of its piece; y is 0 if there is none, and NO_SAMPLE if there are
// several. A plan's halo is not cut. Does nothing while a draw is undecided.
BODY void serve_cut(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 end_box = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end_box; ++number) {
        const HalvedBox box = box_at(ON a, number);
        const bool is_halo = box.whole.at.x - a.own_begin >= a.own_width;
        const Near near = near_of(ON a, number, box);
        u32 total = 0u;
        for (u32 k = 0u; k < 1u << a.strip_bits; ++k) {
            const Strip strip = strip_of(a, box, k);
            Pieces pieces = {strip.at.begin, k == 0u ? strip.at.end : strip.at.begin, 0u};
            if (!is_halo) pieces = cut_strip(ON a, near, strip);
            u32 count = 0u;
            Span first = span_of(0u, 0u);
            Span piece = span_of(pieces.low, pieces.low);
            while (piece.end < pieces.high) {
                piece = next_piece(ON a, near, strip, pieces, piece.end);
                if (piece.begin == piece.end) break;
                if (count == 0u) first = piece;
                ++count;
            }
            STORE(strip_pieces, (number << a.strip_bits) + k,
                  span_of(first.begin, count > 1u ? NO_SAMPLE : first.end));
            total += count;
        }
        AT(counts, number) = total;
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

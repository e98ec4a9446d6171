// The body of locate: walks along the free pieces of a draw's line to the height of its rank. It is
// included after free_spans.h or free_bits.h, which define the pieces.

// Serves a chunk of the draws whose lines are in the slab.
BODY void serve_locate(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    u32 line = NO_SAMPLE;
    u32 slot = 0u;
    u32 number = 0u;
    u32 passed = 0u;
    u32x2 piece = U32X2(0u, 0u);
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const u32x4 draw = AT(draws, i);
        if (draw.x != line) {
            line = draw.x;
            slot = (line - a.slab_begin) * a.g.capacity;
            number = 0u;
            passed = 0u;
            piece = piece_at(ON slot, 0u);
        }

        // Walk the line's pieces until the rank falls into one.
        while (draw.y - passed >= length_of(piece)) {
            passed += length_of(piece);
            ++number;
            piece = piece_at(ON slot, number);
        }

        // A candidate is x, y, line, order.
        AT(located, i) = U32X4(line * a.g.strip_width + draw.z,
                               height_of_rank(piece, draw.y - passed), line, draw.w);
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

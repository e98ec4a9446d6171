// The body of locate: the rank of each draw, walked to a y through the free spans of its line.

// Serves a chunk of the draws of the lines that the slab holds.
BODY void serve_locate(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    u32 line = NO_SAMPLE;
    u32 at = 0u;
    u32 passed = 0u;
    u32x2 span = U32X2(0u, 0u);
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const u32x4 draw = AT(draws, i);
        if (draw.x != line) {
            line = draw.x;
            at = (line - a.slab_begin) * a.g.capacity;
            passed = 0u;
            span = AT(spans, at);
        }

        // Walk the line's spans until the rank falls into one.
        while (draw.y - passed >= span.y - span.x) {
            passed += span.y - span.x;
            ++at;
            span = AT(spans, at);
        }

        // A candidate is x, y, line, order.
        AT(located, i) =
            U32X4(line * a.g.strip_width + draw.z, span.x + (draw.y - passed), line, draw.w);
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

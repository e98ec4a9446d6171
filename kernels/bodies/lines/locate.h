// The body of locate: finds the height of a draw's rank along the free spans of its line. The spans
// of a line lie in tiles (portable/kernels.h), and tile_begins[] has the free length below each.

// The last tile of the line with at most `rank` units of free length below it. The rank lies in it,
// because a tile without free length has the same sum below it as the next tile.
BODY u32 tile_of_rank(MEMORY const u32 first, const u32 tiles, const u32 rank) {
    u32 low = 0u;
    u32 high = tiles;
    while (high - low > 1u) {
        const u32 middle = (low + high) / 2u;
        if (AT(tile_begins, first + middle) <= rank)
            low = middle;
        else
            high = middle;
    }
    return first + low;
}

// Serves a chunk of the draws whose lines are in the slab. A draw's bin is a line. A line's
// draws ascend in rank, so the search for the next one goes on in the same tile.
BODY void serve_locate(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    u32 tile = NO_SAMPLE;
    u32 slot = 0u;
    u32 passed = 0u;  // free length of the line below the span
    Span span = span_of(0u, 0u);
    for (u32 i = begin; i < end; ++i) {
        const Draw draw = LOAD(Draw, draws, i);
        const u32 its_tile = tile_of_rank(ON draw.bin * a.tiles, a.tiles, draw.rank);
        if (its_tile != tile) {
            tile = its_tile;
            slot = (tile - a.slab_begin) * a.g.capacity;
            passed = AT(tile_begins, tile);
            span = LOAD(Span, spans, slot);
        }
        while (draw.rank - passed >= span.end - span.begin) {
            passed += span.end - span.begin;
            ++slot;
            span = LOAD(Span, spans, slot);
        }
        const Candidate candidate = {draw.bin * a.g.strip_width + draw.offset,
                                     span.begin + (draw.rank - passed), draw.bin, draw.order};
        STORE(candidates, i, candidate);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

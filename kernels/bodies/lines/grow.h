// The body of grow: moves a tile's spans from slots of g.capacity spans to slots of `larger` spans.

BODY void serve_grow(MEMORY const SlabArguments a, const u32 item) {
    const u32 tile = a.first_tile + item;
    if (tile >= a.end_tile) return;
    const u32 from = (tile - a.slab_begin) * a.g.capacity;
    const u32 to = (tile - a.to_begin) * a.larger;
    const u32 count = AT(span_counts, tile);
    for (u32 i = 0u; i < count; ++i) STORE(new_spans, to + i, LOAD(Span, spans, from + i));
}

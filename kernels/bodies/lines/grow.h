// The body of grow: moves a line's spans from slots of g.capacity spans to slots of `larger` spans.

BODY void serve_grow(MEMORY const SlabArguments a, const u32 item) {
    const u32 line = a.first_line + item;
    if (line >= a.end_line) return;
    const u32 from = (line - a.slab_begin) * a.g.capacity;
    const u32 to = (line - a.to_begin) * a.larger;
    const u32 count = AT(span_counts, line);
    for (u32 i = 0u; i < count; ++i) AT(new_spans, to + i) = AT(spans, from + i);
}

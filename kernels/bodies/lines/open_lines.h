// The body of open_lines: each tile becomes one free span.

BODY void serve_open_lines(MEMORY const SlabArguments a, const u32 item) {
    const u32 tile = a.first_tile + item;
    if (tile >= a.end_tile) return;
    const u32 begin = tile % a.tiles * a.tile_height;
    const u32 end = begin + min(a.tile_height, a.g.height - begin);
    STORE(spans, (tile - a.slab_begin) * a.g.capacity, span_of(begin, end));
    AT(span_counts, tile) = 1u;
    AT(tile_lengths, tile) = end - begin;
}

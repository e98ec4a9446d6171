// The body of sum_tiles: adds up the free lengths of a line's tiles. An item serves one line.

BODY void serve_sum_tiles(MEMORY const SlabArguments a, const u32 line) {
    if (line >= a.g.lines) return;
    u32 sum = 0u;
    for (u32 tile = line * a.tiles; tile < (line + 1u) * a.tiles; ++tile) {
        AT(tile_begins, tile) = sum;
        sum += AT(tile_lengths, tile);
    }
    AT(results, line) = sum;
}

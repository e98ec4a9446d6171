// The body of insert: puts the round's samples into the sample grid. Does nothing while admission
// is unfinished (undecided[last_pass] != 0).

BODY void serve_insert(MEMORY const DrawArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        if (AT(statuses, i) != STATUS_ADMITTED) continue;
        const u32x4 admitted = AT(candidates, i);
        const u32 cell = admitted.x / a.g.grid_side * a.g.grid_rows + admitted.y / a.g.grid_side;
        AT(grid_x, cell) = admitted.x;
        AT(grid_y, cell) = admitted.y;
    }
}

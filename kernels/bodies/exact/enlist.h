// The body of enlist: adds the admitted candidates that reach a block to the block's neighbour
// list. Does nothing while a draw is undecided. The host has made enough room.

BODY void serve_enlist(MEMORY const DrawArguments a, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 block = item * a.chunk; block < end; ++block) {
        const u32 head = AT(visitor_heads, block);
        u32 count = 0u;
        for (u32 i = head; i != NO_SAMPLE; i = AT(visitors, i).y)
            count += AT(statuses, AT(visitors, i).x) == STATUS_ADMITTED ? 1u : 0u;
        if (count == 0u) continue;
        u32 number = ATOMIC_ADD(entry_count, 0, count);
        u32 next = AT(lists, block);
        for (u32 i = head; i != NO_SAMPLE; i = AT(visitors, i).y) {
            const u32 candidate = AT(visitors, i).x;
            if (AT(statuses, candidate) != STATUS_ADMITTED) continue;
            const u32x4 entry = AT(candidates, candidate);
            AT(entries, number) = U32X4(entry.x, entry.y, AT(candidate_radii, candidate), next);
            next = number;
            ++number;
        }
        AT(lists, block) = next;
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}

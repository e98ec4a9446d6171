// The body of screen_in_cells: decides candidates of a later part of a round whose lattice points
// are blocked by samples of earlier parts.

BODY void serve_screen_in_cells(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        if (AT(statuses, i) != STATUS_UNDECIDED) continue;
        const u32x4 candidate = AT(candidates, i);
        const u32 word = AT(bits, candidate.x * a.g.capacity + candidate.y / 32u);
        if ((word >> (candidate.y % 32u) & 1u) != 0u) continue;
        AT(statuses, i) = STATUS_REJECTED;
        AT(samples, candidate.w) = U32X2(NO_SAMPLE, STATUS_REJECTED);
    }
}

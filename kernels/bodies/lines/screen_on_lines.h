// The body of screen_on_lines: decides candidates of a later part of a round that samples of
// earlier parts cover. The samples' chords were cut from the free spans of the candidates' lines.

// Whether y lies in none of the line's spans.
BODY bool is_cut(MEMORY const u32 slot, const u32 count, const u32 y) {
    u32 low = 0u;
    u32 high = count;
    while (low < high) {
        const u32 middle = (low + high) / 2u;
        if (AT(spans, slot + middle).y <= y)
            low = middle + 1u;
        else
            high = middle;
    }
    return low == count || AT(spans, slot + low).x > y;
}

// Serves the candidates of a chunk whose lines are in the slab.
BODY void serve_screen_on_lines(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    for (u32 i = begin; i < end; ++i) {
        const u32x4 candidate = AT(candidates, i);
        const u32 line = candidate.z;
        if (line < a.first_line || line >= a.end_line || AT(statuses, i) != STATUS_UNDECIDED)
            continue;
        const u32 slot = (line - a.slab_begin) * a.g.capacity;
        if (!is_cut(ON slot, AT(span_counts, line), candidate.y)) continue;
        AT(statuses, i) = STATUS_REJECTED;
        AT(samples, candidate.w) = U32X2(NO_SAMPLE, STATUS_REJECTED);
    }
}

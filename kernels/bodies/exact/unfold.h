// The body of unfold: at the first refinement, turns a line's free spans into boxes as wide as the
// strips, which end where rows of the sample grid do.

// Launched twice: first it writes only the number of boxes to counts[line]; then, after scan.h has
// turned counts into prefix sums, it writes the boxes.
BODY void serve_unfold(MEMORY const SlabArguments a, const u32 item) {
    const u32 line = a.first_line + item;
    if (line >= a.end_line) return;
    const u32 side = a.g.grid_side;
    const u32 slot = (line - a.slab_begin) * a.g.capacity;
    const u32 count = AT(span_counts, line);
    u32 next = a.is_counting != 0u ? 0u : AT(counts, line) + AT(sums, line >> a.block_bits);
    for (u32 i = 0u; i < count; ++i) {
        const u32x2 span = AT(spans, slot + i);
        if (a.is_counting != 0u) {
            next += (span.y - 1u) / side - span.x / side + 1u;
            continue;
        }
        u32 begin = span.x;
        while (begin < span.y) {
            const u32 end = begin + min(span.y - begin, side - begin % side);
            AT(boxes, next) = U32X4(line * a.g.strip_width, a.g.strip_width, begin, end);
            ++next;
            begin = end;
        }
    }
    if (a.is_counting != 0u) AT(counts, line) = next;
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

// The body of unfold: at the first refinement, turns a tile's free spans into boxes as wide as the
// strips, which end where rows of the sample grid do.
#include "bodies/common/sums.h"

// Launched twice: first it writes only the number of boxes to counts[tile]; then, after scan.h has
// turned counts into prefix sums, it writes the boxes.
BODY void serve_unfold(MEMORY const SlabArguments a, const u32 item) {
    const u32 tile = a.first_tile + item;
    if (tile >= a.end_tile) return;
    const u32 side = a.g.grid_side;
    const u32 slot = (tile - a.slab_begin) * a.g.capacity;
    const u32 count = AT(span_counts, tile);
    u32 next = a.block_bits == 0u ? 0u : sum_before(ON tile, a.block_bits);
    for (u32 i = 0u; i < count; ++i) {
        const Span span = LOAD(Span, spans, slot + i);
        if (a.block_bits == 0u) {
            next += (span.end - 1u) / side - span.begin / side + 1u;
            continue;
        }
        u32 begin = span.begin;
        while (begin < span.end) {
            const u32 end = begin + min(span.end - begin, side - begin % side);
            const Box box = {tile / a.tiles * a.g.strip_width, a.g.strip_width, begin, end};
            STORE(boxes, next, box);
            ++next;
            begin = end;
        }
    }
    if (a.block_bits == 0u) AT(counts, tile) = next;
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

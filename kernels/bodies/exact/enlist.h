// The body of enlist: adds the admitted candidates that reach a block to the block's neighbour
// list. Does nothing while a draw is undecided. The host has made enough room.
#include "bodies/exact/factor.h"
#include "portable/conflict.h"

// With several classes: whether the candidate's disk holds the whole block.
BODY bool covers(MEMORY const Geometry g, const u32x4 candidate, const u32 radius,
                 const u32x2 node_and_least) {
    if (g.sheet_bits == BITS_OF_ONE_SHEET) return false;
    const u32x4 box = AT(tree_boxes, node_and_least.x);
    const Sized there = {x_beside(candidate.x, box.x, g.sheet_bits), candidate.y, radius};
    return covers_box(there, box.x, box.y, box.z, box.w, node_and_least.y,
                      factor_of(ON g, candidate.x, box.x), g.period_x, g.period_y);
}

// No more candidates are listed for the block: all of them would be covered. Nor do they descend
// into nodes of which all parts are closed.
BODY void close_block(MEMORY const u32 leaf) {
    if (AT(open_parts, leaf) == 0u) return;
    u32 node = leaf;
    while (ATOMIC_ADD(open_parts, node, ~0u) == 1u && node != 0u) node = AT(tree_links, node).w;
}

BODY void serve_enlist(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 block = item * a.chunk; block < end; ++block) {
        const u32 head = AT(visitor_heads, block);
        u32 count = 0u;
        for (u32 i = head; i != NO_SAMPLE; i = AT(visitors, i).y)
            count += AT(statuses, AT(visitors, i).x) == STATUS_ADMITTED ? 1u : 0u;
        if (count == 0u) continue;
        const u32x2 node_and_least = AT(node_of, block);
        bool is_covered = false;
        u32 number = a.room + ATOMIC_ADD(report, ENTRIES_WORD, count);
        u32 next = AT(lists, block);
        for (u32 i = head; i != NO_SAMPLE; i = AT(visitors, i).y) {
            const u32 candidate = AT(visitors, i).x;
            if (AT(statuses, candidate) != STATUS_ADMITTED) continue;
            const u32x4 entry = AT(candidates, candidate);
            const u32 radius = AT(candidate_radii, candidate);
            AT(entries, number) = U32X4(entry.x, entry.y, radius, next);
            next = number;
            ++number;
            is_covered = is_covered || covers(ON a.g, entry, radius, node_and_least);
        }
        AT(lists, block) = next;
        if (is_covered) close_block(ON node_and_least.x);
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}

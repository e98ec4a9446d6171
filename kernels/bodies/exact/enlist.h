// The body of enlist: adds the admitted candidates that reach a block to the block's neighbour
// list. Does nothing while a draw is undecided. The host has made enough room.
#include "bodies/exact/factor.h"
#include "portable/conflict.h"

// With several classes: whether the candidate's disk holds the whole block.
BODY bool covers(MEMORY const Geometry g, const Candidate candidate, const u32 radius,
                 const BlockNode block) {
    if (g.copy_bits == BITS_OF_ONE_COPY) return false;
    const Box box = LOAD(Box, tree_boxes, block.node);
    const Sized there = {x_beside(candidate.x, box.x, g.copy_bits), candidate.y, radius};
    return covers_box(there, box.x, box.width, box.begin, box.end, block.least,
                      factor_of(ON g, candidate.x, box.x), g.period_x, g.period_y);
}

// No more candidates are listed for the block: all of them would be covered. Nor do they descend
// into nodes of which all parts are closed.
BODY void close_block(MEMORY const u32 leaf) {
    if (AT(open_parts, leaf) == 0u) return;
    u32 node = leaf;
    while (ATOMIC_ADD(open_parts, node, ~0u) == 1u && node != 0u)
        node = LOAD(Links, tree_links, node).whole;
}

BODY void serve_enlist(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 block = item * a.chunk; block < end; ++block) {
        const u32 head = AT(visitor_heads, block);
        u32 count = 0u;
        for (u32 i = head; i != NO_SAMPLE; i = LOAD(Visitor, visitors, i).next)
            count +=
                AT(statuses, LOAD(Visitor, visitors, i).candidate) == STATUS_ADMITTED ? 1u : 0u;
        if (count == 0u) continue;
        const BlockNode its_node = LOAD(BlockNode, node_of, block);
        bool is_covered = false;
        u32 number = a.room + ATOMIC_ADD(report, ENTRIES_WORD, count);
        u32 next = AT(lists, block);
        for (u32 i = head; i != NO_SAMPLE; i = LOAD(Visitor, visitors, i).next) {
            const u32 candidate = LOAD(Visitor, visitors, i).candidate;
            if (AT(statuses, candidate) != STATUS_ADMITTED) continue;
            const Candidate admitted = LOAD(Candidate, candidates, candidate);
            const u32 radius = AT(candidate_radii, candidate);
            const Neighbour entry = {admitted.x, admitted.y, radius, next};
            STORE(entries, number, entry);
            next = number;
            ++number;
            is_covered = is_covered || covers(ON a.g, admitted, radius, its_node);
        }
        AT(lists, block) = next;
        if (is_covered) close_block(ON its_node.node);
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}

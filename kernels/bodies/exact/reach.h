// The body of reach: lists each candidate for all blocks that it reaches (plan/first_boxes.h). So
// all candidates that could conflict with a candidate are in the list of its block. Walks down the
// tree of blocks, as the cpu's neighbour_lists.cpp does.
#include "bodies/exact/ellipses.h"
#include "bodies/exact/factor.h"
#include "portable/conflict.h"

// Whether a candidate is closer to a box than both its own radius and the greatest under the box,
// each times the factor. Its x is on the copy of the box.
BODY bool is_reached(const Box box, const u32 greatest, const Sized candidate, const u64 factor,
                     const u32 period_x, const u32 period_y) {
    return squared_length(distance_to_stretch(candidate.x, box.x, box.x + box.width, period_x),
                          distance_to_stretch(candidate.y, box.begin, box.end, period_y)) <
           squared_limit(candidate.radius, greatest, factor);
}

// Whether the interval `part` contains everything nearer to `at` than the radius. Nothing lies
// beyond an end that it shares with the interval `all`, unless the axis wraps.
BODY bool is_within(const u32 at, const u32 radius, const Span part, const Span all,
                    const u32 period) {
    const bool ends_at_begin = period == 0u && part.begin == all.begin;
    const bool ends_at_end = period == 0u && part.end == all.end;
    return (at - part.begin >= radius || ends_at_begin) && (part.end - at > radius || ends_at_end);
}

// The smallest node of the candidate's copy that holds all blocks that the candidate reaches
// there. `root` is the node of the whole copy.
BODY u32 node_around(MEMORY const DrawArguments a, const Candidate candidate, const u32 radius,
                     const u32 root) {
    const Box all = LOAD(Box, tree_boxes, root);
    u32 node = LOAD(BlockNode, node_of, candidate.home).node;
    while (node > root) {  // a part has a higher number than what it is a part of
        const Box box = LOAD(Box, tree_boxes, node);
        if (is_within(candidate.x, radius, span_of(box.x, box.x + box.width),
                      span_of(all.x, all.x + all.width), a.g.period_x) &&
            is_within(candidate.y, radius, span_of(box.begin, box.end), span_of(all.begin, all.end),
                      a.g.period_y))
            break;
        node = LOAD(Links, tree_links, node).whole;
    }
    return node;
}

// Lists a candidate for its own block and the open ones of one copy that it reaches, and returns
// the node after the copy. `root` is the node of the whole copy.
BODY u32 list_on_copy(MEMORY const DrawArguments a, const u32 i, const u32 root) {
    const Candidate candidate = LOAD(Candidate, candidates, i);
    const u32 copy_x = LOAD(Box, tree_boxes, root).x;
    const u64 factor = factor_of(ON a.g, candidate.x, copy_x);
    const Sized there = {x_beside(candidate.x, copy_x, a.g.copy_bits), candidate.y,
                         AT(candidate_radii, i)};
    const bool has_block = candidate.home != NO_SAMPLE && there.x == candidate.x;
    const u32 first =
        has_block ? node_around(ON a, candidate, times_factor(there.radius, factor), root) : root;
    // Within a part of the domain the way around the torus is never shorter.
    const u32 period_x = first == root ? a.g.period_x : 0u;
    const u32 period_y = first == root ? a.g.period_y : 0u;
    const bool has_ellipse = a.g.rule == RULE_OF_ELLIPSES;
    Ellipse ellipse = {0u, 0u, 0u, 0u};
    if (has_ellipse) ellipse = ellipse_at(ON candidate.x, candidate.y);
    const bool has_classes = a.g.copy_bits != BITS_OF_ONE_COPY;
    const bool is_all = a.first_node == ALL_NODES;
    const u32 next = LOAD(Links, tree_links, first).next;
    const u32 end = is_all ? next : min(next, a.first_node + NODES_AT_ONCE);
    u32 node = is_all ? first : max(first, a.first_node);
    while (node < end) {
        const Links links = LOAD(Links, tree_links, node);
        const Box box = LOAD(Box, tree_boxes, node);
        const bool is_closed = has_classes && AT(open_parts, node) == 0u;
        const bool is_own = there.x == candidate.x && there.x - box.x < box.width &&
                            there.y >= box.begin && there.y < box.end;
        if ((is_closed && !is_own) ||
            !is_reached(box, links.greatest, there, factor, period_x, period_y) ||
            (has_ellipse && ellipse_misses(there, ellipse, box.x, box.width, box.begin, box.end,
                                           period_x, period_y))) {
            node = links.next;
            continue;
        }
        ++node;
        if (node != links.next) continue;
        const u32 number = ATOMIC_ADD(report, VISITORS_WORD, 1u);
        if (number >= a.room) continue;
        const u32 earlier = ATOMIC_SET(visitor_heads, links.first_block, number);
        const Visitor visitor = {i, earlier};
        STORE(visitors, number, visitor);
    }
    return LOAD(Links, tree_links, root).next;
}

// Lists a candidate for all blocks that it reaches. If the room is too small, the rest is only
// counted: the host sees the number, makes room and launches again.
BODY void list_reached(MEMORY const DrawArguments a, const u32 i) {
    const u32 end = LOAD(Links, tree_links, 0u).next;
    u32 root = a.g.copy_bits == BITS_OF_ONE_COPY ? 0u : 1u;  // copies are the parts of node 0
    while (root < end) root = list_on_copy(ON a, i, root);
}

// Does not list covered and rejected candidates. If a round has one part, only the survivors are
// served, so that no items in lockstep wait for others.
BODY void serve_reach(MEMORY const DrawArguments a, const u32 item) {
    const bool is_listed = a.is_listed != 0u;
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, is_listed ? AT(report, SURVIVORS_WORD) : a.count);
    for (u32 k = begin; k < end; ++k) {
        const u32 i = is_listed ? AT(survivors, k) : k;
        const u32 status = AT(statuses, i);
        if (status == STATUS_UNDECIDED || status == STATUS_ADMITTED) list_reached(ON a, i);
    }
    CHECK_TURNS(a.g.height, FAILED_ADMIT);
}

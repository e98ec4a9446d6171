// The body of own_crowded: in a leaf that has more rivals than room each lattice point is for
// itself: its owner is searched among all sites, and gets its mass at once.
#include "bodies/leaf.h"
#include "bodies/shares.h"

BODY u64 power_at(const LeafArguments a, const u32x4 site, const u32 x, const u32 y) {
    return power_of(x, y, site.x, site.y, join_words(site.z, site.w), a.lattice.period_x,
                    a.lattice.period_y);
}

// How far [low, high] is from `at` on an axis, or from an image of it.
BODY u32 gap_around(const u32 low, const u32 high, const u32 at, const u32 period) {
    const u32 below = at < low ? low - at : 0u;
    const u32 above = at > high ? at - high : 0u;
    const u32 straight = max(below, above);
    if (period == 0u || straight == 0u) return straight;
    // The image that lies on the other side.
    const u32 around = at < low ? period + at - high : low + period - at;
    return min(straight, around);
}

// The least power, and among sites that have it the lowest index.
BODY u32 owner_of(MEMORY const LeafArguments a, const u32 hint, const u32 x, const u32 y) {
    u32 owner = hint;
    u64 least = power_at(a, AT(sites, hint), x, y);
    Cursor at;
    at.level = a.depth;
    at.index = 0u;
    at.begin = 0u;
    while (at.level <= a.depth) {
        if (at.level != 0u) {
            const u32x4 node = AT(node_boxes, at.begin + at.index);
            const u32x2 lift = AT(node_lifts, at.begin + at.index);
            const u64 power = squared_length(gap_around(node.x, node.z, x, a.lattice.period_x),
                                             gap_around(node.y, node.w, y, a.lattice.period_y)) +
                              join_words(lift.x, lift.y);
            if (power <= least) {
                at = below_cursor(at);
                continue;
            }
        } else {
            const u64 power = power_at(a, AT(sites, at.index), x, y);
            if (power < least || (power == least && AT(indices, at.index) < AT(indices, owner))) {
                least = power;
                owner = at.index;
            }
        }
        at = next_cursor(at, a.lattice.samples, a.depth);
    }
    return owner;
}

BODY void own_crowded_row(MEMORY const LeafArguments a, const u32 row) {
    const u32 index = row / LEAF_SIDE;
    const Leaf leaf = leaf_at(ON a, index);
    const u32 v = leaf.bottom + row % LEAF_SIDE;
    const u32x4 masses_of = AT(row_masses, row);
    for (u32 i = 0u; i < leaf.width; ++i) {
        const u32 two = i < 2u   ? masses_of.x
                        : i < 4u ? masses_of.y
                        : i < 6u ? masses_of.z
                                 : masses_of.w;
        const u32 mass = two >> (i % 2u * 16u) & 0xffffu;
        if (mass == 0u) continue;
        const u32 u = leaf.left + i;
        const u32 owner =
            owner_of(ON a, AT(hints, a.first_leaf + index), lattice_place(u, a.lattice.step_x),
                     lattice_place(v, a.lattice.step_y));
        const u32x4 site = AT(sites, owner);
        const u64 wide = mass;
        add_to_share(
            ON owner, 1u, mass,
            wide *
                moment_offset(u, site.x, a.lattice.step_x, a.lattice.columns, a.lattice.period_x),
            wide * moment_offset(v, site.y, a.lattice.step_y, a.lattice.rows, a.lattice.period_y));
        if (a.is_telling != 0u) AT(owners, v * a.lattice.columns + u) = AT(indices, owner);
    }
}

// An item serves whole leaves: lavapipe spends the time of one turn of each loop on those that are
// not crowded, too.
BODY void serve_own_crowded(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 index = item * a.chunk; index < end; ++index) {
        if (AT(rival_counts, index) != CROWDED) continue;
        for (u32 v = 0u; v < LEAF_SIDE; ++v) own_crowded_row(ON a, index * LEAF_SIDE + v);
    }
    CHECK_TURNS(a.lattice.columns, FAILED_OWN);
}

// Searches the owner of a lattice point among all sites.
#include "bodies/relax/site.h"
#include "portable/site_tree.h"

BODY u64 power_at(const LeafArguments a, const Site site, const u32 x, const u32 y) {
    return power_of(x, y, site.x, site.y, weight_of(site), a.lattice.period_x, a.lattice.period_y);
}

// The distance from `at`, or from an image of it, to [low, high] on an axis.
BODY u32 gap_around(const u32 low, const u32 high, const u32 at, const u32 period) {
    const u32 below = at < low ? low - at : 0u;
    const u32 above = at > high ? at - high : 0u;
    const u32 straight = max(below, above);
    if (period == 0u || straight == 0u) return straight;
    // The way around to the other end.
    const u32 around = at < low ? period + at - high : low + period - at;
    return min(straight, around);
}

// The site with the least power; among equals the lowest index.
BODY u32 owner_of(MEMORY const LeafArguments a, const u32 hint, const u32 x, const u32 y) {
    u32 owner = hint;
    u64 least = power_at(a, LOAD(Site, sites, hint), x, y);
    Cursor at;
    at.level = a.depth;
    at.index = 0u;
    at.begin = 0u;
    while (at.level <= a.depth) {
        if (at.level != 0u) {
            const Bounds node = LOAD(Bounds, node_boxes, at.begin + at.index);
            const u64 power =
                squared_length(gap_around(node.low_x, node.high_x, x, a.lattice.period_x),
                               gap_around(node.low_y, node.high_y, y, a.lattice.period_y)) +
                number_of(LOAD(Wide, node_weights, at.begin + at.index));
            if (power <= least) {
                at = below_cursor(at);
                continue;
            }
        } else {
            const u64 power = power_at(a, LOAD(Site, sites, at.index), x, y);
            if (power < least || (power == least && AT(indices, at.index) < AT(indices, owner))) {
                least = power;
                owner = at.index;
            }
        }
        at = next_cursor(at, a.lattice.samples, a.depth);
    }
    return owner;
}

// The body of limit: limits the weight of each site by the squared distance to the nearest other
// one. An item serves leaves of the tree: nodes of level 1, with up to 8 sites.
#include "bodies/relax/site.h"
#include "portable/bits.h"
#include "portable/site_tree.h"

// The distance between two intervals on an axis, both ends included.
BODY u32 gap_between(const u32 low, const u32 high, const u32 begin, const u32 last,
                     const u32 period) {
    const u32 straight = interval_gap(to_i32(low), to_i32(high), to_i32(begin), to_i32(last));
    const u32 around = period - (max(high, last) - min(low, begin));
    return period != 0u ? min(straight, around) : straight;
}

BODY u64 distance_to_node(MEMORY const SiteArguments a, const Bounds box, const u32 index) {
    const Bounds node = LOAD(Bounds, node_boxes, index);
    return squared_length(
        gap_between(box.low_x, box.high_x, node.low_x, node.high_x, a.lattice.period_x),
        gap_between(box.low_y, box.high_y, node.low_y, node.high_y, a.lattice.period_y));
}

// Until a leaf is done, `limited` has positions, and the least squared distances that were found.
// Lowers those of the sites in `leaf` by the sites in `other`. Returns the greatest of them.
BODY u64 lower_by_leaf(MEMORY const SiteArguments a, const u32 leaf, const u32 other) {
    const u32 end = min(leaf * 8u + 8u, a.lattice.samples);
    const u32 end_other = min(other * 8u + 8u, a.lattice.samples);
    u64 farthest = 0u;
    for (u32 i = leaf * 8u; i < end; ++i) {
        const Site site = LOAD(Site, limited, i);
        u64 nearest = weight_of(site);
        const Bounds box = bounds_of(site);
        if (distance_to_node(ON a, box, a.level_begin + other) < nearest) {
            for (u32 j = other * 8u; j < end_other; ++j) {
                const Site to = LOAD(Site, sites, j);
                const u64 distance = power_of(site.x, site.y, to.x, to.y, 0u, a.lattice.period_x,
                                              a.lattice.period_y);
                nearest = j != i && distance < nearest ? distance : nearest;
            }
            STORE(limited, i, with_weight(site, nearest));
        }
        farthest = nearest > farthest ? nearest : farthest;
    }
    return farthest;
}

// The next node of level 2 that is nearer to the box; beyond the root if there is none.
BODY Cursor next_near_node(MEMORY const SiteArguments a, Cursor at, const Bounds box,
                           const u64 farthest) {
    while (at.level <= a.depth) {
        const bool is_near = distance_to_node(ON a, box, at.begin + at.index) < farthest;
        if (is_near && at.level == 2u) break;
        at = step_cursor(at, is_near, a.lattice.samples, a.depth);
    }
    return at;
}

// Bit i is set if leaf first + i is nearer to the box. In a loop without branches, which processors
// run on several leaves at once.
BODY u32 near_leaves(MEMORY const SiteArguments a, const u32 first, const Bounds box,
                     const u64 farthest) {
    const u32 leaves = nodes_of_level(a.lattice.samples, 1u);
    u32 near = 0u;
    for (u32 i = 0u; i < 8u; ++i) {
        const u32 index = a.level_begin + min(first + i, leaves - 1u);
        const bool is_near = distance_to_node(ON a, box, index) < farthest;
        near = near | (is_near && first + i < leaves ? 1u << i : 0u);
    }
    return near;
}

// Lowers what was found for the sites of a leaf by those of all leaves that are nearer to the box
// than `farthest`: the greatest of what was found, or that of site `only` if there is one.
BODY void lower_by_near_leaves(MEMORY const SiteArguments a, const u32 leaf, const Bounds box,
                               u64 farthest, const u32 only) {
    Cursor at;
    at.level = a.depth;
    at.index = 0u;
    at.begin = 0u;
    while (at.level >= 2u && at.level <= a.depth) {
        at = next_near_node(ON a, at, box, farthest);
        if (at.level > a.depth) break;
        u32 near = near_leaves(ON a, at.index * 8u, box, farthest);
        for (; near != 0u; near &= near - 1u) {
            const u32 other = at.index * 8u + lowest_bit(near);
            if (other != leaf) {
                const u64 of_all = lower_by_leaf(ON a, leaf, other);
                farthest = only < a.lattice.samples ? weight_of(LOAD(Site, limited, only)) : of_all;
            }
        }
        at = next_cursor(at, a.lattice.samples, a.depth);
    }
}

BODY bool is_over_half(const u32 low, const u32 high, const u32 period) {
    return period != 0u && high - low > period / 2u;
}

// The leaf itself comes first: its sites are near each other, so that most others are skipped. But
// on a torus some may lie at the other edge, and the box of all is as wide as the domain. Then each
// site is searched for alone.
BODY void find_nearest(MEMORY const SiteArguments a, const u32 leaf) {
    const Bounds box = LOAD(Bounds, node_boxes, a.level_begin + leaf);
    const u64 farthest = lower_by_leaf(ON a, leaf, leaf);
    if (!is_over_half(box.low_x, box.high_x, a.lattice.period_x) &&
        !is_over_half(box.low_y, box.high_y, a.lattice.period_y)) {
        lower_by_near_leaves(ON a, leaf, box, farthest, a.lattice.samples);
        return;
    }
    const u32 end = min(leaf * 8u + 8u, a.lattice.samples);
    for (u32 i = leaf * 8u; i < end; ++i) {
        const Site site = LOAD(Site, limited, i);
        lower_by_near_leaves(ON a, leaf, bounds_of(site), weight_of(site), i);
    }
}

BODY void limit_leaf(MEMORY const SiteArguments a, const u32 leaf) {
    const u32 end = min(leaf * 8u + 8u, a.lattice.samples);
    for (u32 i = leaf * 8u; i < end; ++i) {
        const Site site = LOAD(Site, sites, i);
        const u64 reach = reach_of_weight(a.lattice.farthest, weight_of(site));
        STORE(limited, i, with_weight(site, reach));
    }
    find_nearest(ON a, leaf);
    for (u32 i = leaf * 8u; i < end; ++i) {
        const Site site = LOAD(Site, sites, i);
        const u64 weight =
            bounded_weight(a.lattice.farthest, weight_of(site), weight_of(LOAD(Site, limited, i)));
        STORE(limited, i, with_weight(site, weight));
    }
}

BODY void serve_limit(MEMORY const SiteArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, nodes_of_level(a.lattice.samples, 1u));
    for (u32 leaf = item * a.chunk; leaf < end; ++leaf) limit_leaf(ON a, leaf);
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}

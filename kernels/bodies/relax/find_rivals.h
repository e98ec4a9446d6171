// The body of find_rivals: lists the sites that may win lattice points of a unit.
#include "bodies/relax/late.h"
#include "bodies/relax/leaf.h"
#include "bodies/relax/nodes.h"
#include "bodies/relax/unit_leaves.h"
#include "portable/bits.h"

BODY u64 power_of_site(const Site site, const Rect box) {
    return least_power(to_i32(site.x), to_i32(site.y), to_i32(site.x), to_i32(site.y),
                       weight_of(site), box);
}

BODY Rival rival_in(const Site site, const Rect box) {
    return rival_of(to_i32(site.x) - box.left, to_i32(site.y) - box.bottom, weight_of(site));
}

// The criteria of a search in a unit.
struct Search {
    Rival first;  // the hint of the first leaf: all other sites are compared with it
    u64 bound;    // a site that may win has at most this power somewhere in the unit
};
LACUNA_TYPEDEF(Search)

// The winner of a lattice point has at most the power there that its leaf's hint has in the leaf's
// worst corner.
BODY Search search_in(MEMORY const LeafArguments a, const Area unit, const u32 leaves) {
    Search search;
    search.bound = 0u;
    for (u32 rest = leaves; rest != 0u; rest &= rest - 1u) {
        const Area leaf = leaf_of(a, unit, lowest_bit(rest));
        const u64 bound = bound_by(a, LOAD(Site, sites, AT(hints, number_of_leaf(a, leaf))), leaf);
        search.bound = bound > search.bound ? bound : search.bound;
    }
    const Area leaf = leaf_of(a, unit, lowest_bit(leaves));
    const Site site = LOAD(Site, sites, AT(hints, number_of_leaf(a, leaf)));
    const u32 image = image_near(a, site, leaf);
    search.first = rival_in(site, rect_of(a, unit, image % 3u, image / 3u));
    return search;
}

// If two images are equally far away, the one in the domain wins, as in moment_offset.
BODY u32 order_of_image(const u32 image) {
    const u32 x = image % 3u;
    const u32 y = image / 3u;
    return (x != 1u ? 4u : 0u) + (y != 1u ? 8u : 0u) + x / 2u + y / 2u * 2u;
}

// Writes a site that may win by image 3 y + x into the unit's slot. False if the slot is full, or
// the lag does not fit into 32 bits.
BODY bool put_rival(MEMORY const LeafArguments a, const u32 slot, const u32 count, const u32 number,
                    const Rival first, const Rect box, const u32 image) {
    if (count >= RIVAL_ROOM) return false;
    const Lag lag =
        lag_of(rival_in(LOAD(Site, sites, number), box), first, a.lattice.step_x, a.lattice.step_y);
    const ShortLag rival = {to_i32(to_u32(lag.at)), to_i32(to_u32(lag.along_x)),
                            to_i32(to_u32(lag.along_y)),
                            AT(indices, number) * 16u + order_of_image(image)};
    STORE(rivals, slot + count, rival);
    AT(rival_ids, slot + count) = number * 16u + image;
    return is_short(lag, a.side * LEAF_SIDE - 1u);
}

// The next node of level 1 that may have a rival; beyond the root if there is none.
BODY Cursor next_near(MEMORY const LeafArguments a, Cursor at, const u64 bound, const Rect box) {
    while (at.level <= a.depth) {
        const bool is_near = power_of_node(ON at.begin + at.index, box) <= bound;
        if (is_near && at.level == 1u) break;
        at = step_cursor(at, is_near, a.lattice.samples, a.depth);
    }
    return at;
}

// Bit i is set if site first + i may win. This loop is separate from the work for such sites: they
// are few, and on lavapipe every turn of a loop takes the time of all its branches.
BODY u32 near_sites(MEMORY const LeafArguments a, const u32 first, const Search search,
                    const Rect box) {
    const u32 width = to_u32(box.right - box.left);
    const u32 height = to_u32(box.top - box.bottom);
    u32 near = 0u;
    for (u32 i = 0u; i < 8u; ++i) {
        const Site site = LOAD(Site, sites, min(first + i, a.lattice.samples - 1u));
        const bool is_near = power_of_site(site, box) <= search.bound &&
                             can_win(rival_in(site, box), search.first, width, height);
        near = near | (is_near && first + i < a.lattice.samples ? 1u << i : 0u);
    }
    return near;
}

// Bit 3 y + x is set if image (x, y) of the domain may have a rival. On a box only the domain
// itself is considered.
BODY u32 near_images(MEMORY const LeafArguments a, const Area unit, const u64 bound) {
    if (a.lattice.period_x == 0u) return 16u;
    u32 near = 0u;
    for (u32 image = 0u; image < 9u; ++image) {
        const u64 power = power_of_node(ON 0u, rect_of(a, unit, image % 3u, image / 3u));
        near = near | (power <= bound ? 1u << image : 0u);
    }
    return near;
}

// Returns the number of rivals; CROWDED if put_rival failed or, by a fault, there is no rival.
BODY u32 list_rivals(MEMORY const LeafArguments a, const Area unit, const Search search,
                     const u32 slot) {
    u32 count = 0u;
    bool has_room = true;
    for (u32 rest = near_images(ON a, unit, search.bound); rest != 0u; rest &= rest - 1u) {
        const u32 image = lowest_bit(rest);
        const Rect box = rect_of(a, unit, image % 3u, image / 3u);
        Cursor at;
        at.level = a.depth;
        at.index = 0u;
        at.begin = 0u;
        while (has_room) {
            at = next_near(ON a, at, search.bound, box);
            if (at.level > a.depth) break;
            u32 near = near_sites(ON a, at.index * 8u, search, box);
            while (near != 0u) {
                const u32 number = at.index * 8u + lowest_bit(near);
                near = near & (near - 1u);
                has_room =
                    put_rival(ON a, slot, count, number, search.first, box, image) && has_room;
                ++count;
            }
            at = next_cursor(at, a.lattice.samples, a.depth);
        }
    }
    return has_room && count != 0u ? count : CROWDED;
}

BODY void serve_find_rivals(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 index = item * a.chunk; index < end; ++index) {
        const Area unit = unit_at(ON a, index);
        const u32 leaves = leaves_of_unit(ON a, index);
        const Search search = search_in(ON a, unit, leaves);
        const u32 count = list_rivals(ON a, unit, search, index * RIVAL_ROOM);
        AT(rival_counts, index) = count;
        if (count == CROWDED)
            for (u32 rest = leaves; rest != 0u; rest &= rest - 1u)
                leave_for_later(ON number_of_leaf(a, leaf_of(a, unit, lowest_bit(rest))));
    }
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}

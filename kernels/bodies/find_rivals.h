// The body of find_rivals: the sites that may win lattice points of a leaf, in the order of ties.
#include "bodies/leaf.h"
#include "portable/bits.h"

// The leaf as image (x, y) of the domain sees it: 0, 1 and 2 are a period below, the domain itself,
// and a period above.
BODY Rect rect_of(const LeafArguments a, const Leaf leaf, const u32 x, const u32 y) {
    const i32 shift_x = to_i32(a.lattice.period_x - x * a.lattice.period_x);
    const i32 shift_y = to_i32(a.lattice.period_y - y * a.lattice.period_y);
    const i32 left = to_i32(lattice_place(leaf.left, a.lattice.step_x)) + shift_x;
    const i32 bottom = to_i32(lattice_place(leaf.bottom, a.lattice.step_y)) + shift_y;
    Rect box;
    box.left = left;
    box.bottom = bottom;
    box.right = left + to_i32((leaf.width - 1u) * a.lattice.step_x);
    box.top = bottom + to_i32((leaf.height - 1u) * a.lattice.step_y);
    return box;
}

// Which image of a site at `at` is the nearest to a place on an axis.
BODY u32 nearest_image(const u32 at, const u32 place, const u32 period) {
    if (period == 0u) return 1u;
    const u32 off = at > place ? at - place : place - at;
    return off <= period / 2u ? 1u : at > place ? 0u : 2u;
}

BODY u64 power_of_site(const u32x4 site, const Rect box) {
    return least_power(to_i32(site.x), to_i32(site.y), to_i32(site.x), to_i32(site.y),
                       join_words(site.z, site.w), box);
}

BODY u64 power_of_node(MEMORY const u32 index, const Rect box) {
    const u32x4 node = AT(node_boxes, index);
    const u32x2 lift = AT(node_lifts, index);
    return least_power(to_i32(node.x), to_i32(node.y), to_i32(node.z), to_i32(node.w),
                       join_words(lift.x, lift.y), box);
}

// A site near the box: down the tree, always to the child that may be the nearest.
BODY u32 site_near(MEMORY const LeafArguments a, const Rect box) {
    u32 begin = 0u;
    u32 nearest = 0u;
    for (u32 level = a.depth; level > 1u; --level) {
        const u32 first = nearest * 8u;
        const u32 end = min(first + 8u, nodes_of_level(a.lattice.samples, level - 1u));
        begin = begin * 8u + 1u;
        u64 least = power_of_node(ON begin + first, box);
        nearest = first;
        for (u32 child = first + 1u; child < end; ++child) {
            const u64 power = power_of_node(ON begin + child, box);
            nearest = power < least ? child : nearest;
            least = power < least ? power : least;
        }
    }
    return nearest * 8u;
}

// The best so far in the leaf's middle.
struct Leader {
    Rival rival;
    u32 site;
    u64 bound;  // its power in the leaf's worst corner: whoever has more everywhere cannot win
};
LACUNA_TYPEDEF(Leader)

BODY Rival rival_in(const u32x4 site, const Rect box) {
    return rival_of(to_i32(site.x) - box.left, to_i32(site.y) - box.bottom,
                    join_words(site.z, site.w));
}

BODY Leader leader_of(const u32 number, const u32x4 site, const Rect box) {
    Leader leader;
    leader.rival = rival_in(site, box);
    leader.site = number;
    leader.bound = worst_power(to_i32(site.x), to_i32(site.y), join_words(site.z, site.w), box);
    return leader;
}

// From the site that led when the leaf was last looked at, or a first one.
BODY Leader first_leader(MEMORY const LeafArguments a, const u32 index, const Leaf leaf) {
    u32 site = AT(hints, a.first_leaf + index);
    if (site == NO_OWNER) site = site_near(ON a, rect_of(a, leaf, 1u, 1u));
    const u32x4 at = AT(sites, site);
    const u32 x =
        nearest_image(at.x, lattice_place(leaf.left, a.lattice.step_x), a.lattice.period_x);
    const u32 y =
        nearest_image(at.y, lattice_place(leaf.bottom, a.lattice.step_y), a.lattice.period_y);
    return leader_of(site, at, rect_of(a, leaf, x, y));
}

// A site that may win by image (x, y): into the leaf's slot, or only counted where that is full.
BODY void put_rival(MEMORY const u32 slot, const u32 count, const u32 number, const u32x4 site,
                    const Rect box, const u32 image) {
    if (count >= RIVAL_ROOM) return;
    const u32 x = to_u32(to_i32(site.x) - box.left);
    const u32 y = to_u32(to_i32(site.y) - box.bottom);
    // Of two images equally far away the one within the domain wins, as in moment_offset.
    const u32 off = (image % 3u != 1u ? 1u : 0u) + (image / 3u != 1u ? 2u : 0u);
    AT(rivals, slot + count) = U32X4(x, y, site.z, site.w);
    AT(rival_ids, slot + count) = U32X2(number * 16u + image, AT(indices, number) * 4u + off);
}

// Of the rivals those that the leader does not beat everywhere, sorted into `ranked`. Returns how
// many.
BODY u32 rank_rivals(MEMORY const u32 slot, const u32 count, const Rival leader, const u32 width,
                     const u32 height) {
    u32 kept = 0u;
    for (u32 i = 0u; i < count; ++i) {
        const u32x4 near = AT(rivals, slot + i);
        const Rival rival = rival_of(to_i32(near.x), to_i32(near.y), join_words(near.z, near.w));
        if (!can_win(rival, leader, width, height)) continue;
        const u32 order = AT(rival_ids, slot + i).y;
        u32 to = kept;
        while (to > 0u && AT(rival_ids, slot + AT(ranked, slot + to - 1u)).y > order) {
            AT(ranked, slot + to) = AT(ranked, slot + to - 1u);
            --to;
        }
        AT(ranked, slot + to) = i;
        ++kept;
    }
    return kept;
}

// The next node of level 1 that may have a rival; past the root, where there is none.
BODY Cursor next_near(MEMORY const LeafArguments a, Cursor at, const u64 bound, const Rect box) {
    bool is_found = false;
    while (!is_found && at.level <= a.depth) {
        const bool is_near = power_of_node(ON at.begin + at.index, box) <= bound;
        is_found = is_near && at.level == 1u;
        if (is_found) break;
        const Cursor below = below_cursor(at);
        const Cursor next = next_cursor(at, a.lattice.samples, a.depth);
        at.level = is_near ? below.level : next.level;
        at.index = is_near ? below.index : next.index;
        at.begin = is_near ? below.begin : next.begin;
    }
    return at;
}

// Bit i tells whether site first + i may win. Apart from the work for those that may, as they are
// few, and lavapipe spends the time of all branches on each turn of a loop.
BODY u32 near_sites(MEMORY const LeafArguments a, const u32 first, const Leader leader,
                    const Rect box) {
    const u32 width = to_u32(box.right - box.left);
    const u32 height = to_u32(box.top - box.bottom);
    u32 near = 0u;
    for (u32 i = 0u; i < 8u; ++i) {
        const u32x4 site = AT(sites, min(first + i, a.lattice.samples - 1u));
        const bool is_near = power_of_site(site, box) <= leader.bound &&
                             can_win(rival_in(site, box), leader.rival, width, height);
        near = near | (is_near && first + i < a.lattice.samples ? 1u << i : 0u);
    }
    return near;
}

// Bit 3 y + x tells whether image (x, y) of the domain may have a rival. On a box the domain
// itself.
BODY u32 near_images(MEMORY const LeafArguments a, const Leaf leaf, const u64 bound) {
    if (a.lattice.period_x == 0u) return 16u;
    u32 near = 0u;
    for (u32 image = 0u; image < 9u; ++image) {
        const u64 power = power_of_node(ON 0u, rect_of(a, leaf, image % 3u, image / 3u));
        near = near | (power <= bound ? 1u << image : 0u);
    }
    return near;
}

BODY void find_rivals_of(MEMORY const LeafArguments a, const u32 index) {
    const Leaf leaf = leaf_at(ON a, index);
    const u32 right = leaf.width / 2u * a.lattice.step_x;  // of the middle
    const u32 up = leaf.height / 2u * a.lattice.step_y;
    const u32 slot = index * RIVAL_ROOM;
    Leader leader = first_leader(ON a, index, leaf);
    i64 least = rival_value(leader.rival, right, up);
    u32 count = RIVAL_ROOM + 1u;
    // A leader from long ago lets many in before a better one is found: then once more.
    for (u32 round = 0u; round < 2u && count > RIVAL_ROOM; ++round) {
        count = 0u;
        for (u32 rest = near_images(ON a, leaf, leader.bound); rest != 0u; rest &= rest - 1u) {
            const u32 image = lowest_bit(rest);
            const Rect box = rect_of(a, leaf, image % 3u, image / 3u);
            Cursor at;
            at.level = a.depth;
            at.index = 0u;
            at.begin = 0u;
            while (true) {
                at = next_near(ON a, at, leader.bound, box);
                if (at.level > a.depth) break;
                u32 near = near_sites(ON a, at.index * 8u, leader, box);
                while (near != 0u) {
                    const u32 number = at.index * 8u + lowest_bit(near);
                    near = near & (near - 1u);
                    const u32x4 site = AT(sites, number);
                    put_rival(ON slot, count, number, site, box, image);
                    ++count;
                    const Leader other = leader_of(number, site, box);
                    const i64 value = rival_value(other.rival, right, up);
                    if (value < least) {
                        least = value;
                        leader = other;
                    }
                }
                at = next_cursor(at, a.lattice.samples, a.depth);
            }
        }
    }
    AT(hints, a.first_leaf + index) = leader.site;
    AT(rival_counts, index) =
        count > RIVAL_ROOM
            ? CROWDED
            : rank_rivals(ON slot, count, leader.rival, (leaf.width - 1u) * a.lattice.step_x,
                          (leaf.height - 1u) * a.lattice.step_y);
}

BODY void serve_find_rivals(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count);
    for (u32 index = item * a.chunk; index < end; ++index) find_rivals_of(ON a, index);
    CHECK_TURNS(a.lattice.columns, FAILED_OWN);
}

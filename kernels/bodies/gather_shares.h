// The body of gather_shares: what the rivals of a leaf have won of it goes to the shares of their
// sites. An item serves every 8th rank of a leaf.
#include "bodies/leaf.h"
#include "bodies/shares.h"

#define ITEMS_OF_LEAF 8u

// Of lattice points 0, 1, ...: how many, their mass, and that times u or v.
struct Won {
    u32 points;
    u32 mass;
    u32 moment_u;
    u32 moment_v;
};
LACUNA_TYPEDEF(Won)

// Two neighbours in a row: `ranks` has those who own them in its lowest bytes.
BODY Won add_two(const Won sum, const u32 two, const u32 ranks, const u32 rank, const u32 u) {
    const u32 first = (ranks & 0xffu) == rank ? two & 0xffffu : 0u;
    const u32 second = (ranks >> 8 & 0xffu) == rank ? two >> 16 : 0u;
    Won more = sum;
    more.points += (first != 0u ? 1u : 0u) + (second != 0u ? 1u : 0u);
    more.mass += first + second;
    more.moment_u += (first + second) * u + second;
    return more;
}

BODY Won won_by(MEMORY const u32 index, const u32 rank) {
    Won all;
    all.points = 0u;
    all.mass = 0u;
    all.moment_u = 0u;
    all.moment_v = 0u;
    for (u32 v = 0u; v < LEAF_SIDE; ++v) {
        const u32x4 masses_of = AT(row_masses, index * LEAF_SIDE + v);
        const u32x2 ranks = AT(winners, index * LEAF_SIDE + v);
        const u32 before = all.mass;
        all = add_two(all, masses_of.x, ranks.x, rank, 0u);
        all = add_two(all, masses_of.y, ranks.x >> 16, rank, 2u);
        all = add_two(all, masses_of.z, ranks.y, rank, 4u);
        all = add_two(all, masses_of.w, ranks.y >> 16, rank, 6u);
        all.moment_v += (all.mass - before) * v;
    }
    return all;
}

BODY void gather_leaf(MEMORY const LeafArguments a, const u32 index, const u32 first_rank) {
    const u32 count = AT(rival_counts, index);
    if (count == CROWDED) return;
    const Leaf leaf = leaf_at(ON a, index);
    const u32 slot = index * RIVAL_ROOM;
    for (u32 rank = first_rank; rank < count; rank += ITEMS_OF_LEAF) {
        const Won won = won_by(ON index, rank);
        if (won.points == 0u) continue;
        const u32 id = AT(rival_ids, slot + AT(ranked, slot + rank)).x;
        const u32 image = id % 16u;
        const u32x4 site = AT(sites, id / 16u);
        const u64 mass = won.mass;
        add_to_share(ON id / 16u, won.points, won.mass,
                     won.moment_u + mass * leaf_offset(leaf.left, site.x, a.lattice.step_x,
                                                       a.lattice.columns, image % 3u),
                     won.moment_v + mass * leaf_offset(leaf.bottom, site.y, a.lattice.step_y,
                                                       a.lattice.rows, image / 3u));
    }
}

BODY void serve_gather_shares(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count * ITEMS_OF_LEAF);
    for (u32 i = item * a.chunk; i < end; ++i)
        gather_leaf(ON a, i / ITEMS_OF_LEAF, i % ITEMS_OF_LEAF);
}

// The body of own: which of a leaf's rivals wins each lattice point of a row of it, and the masses
// of these points.
#include "bodies/leaf.h"

// Of a row of the leaf, two a word; 0 outside of the lattice.
BODY u32x4 masses_of_row(MEMORY const LeafArguments a, const Leaf leaf, const u32 v) {
    if (v >= leaf.height) return U32X4(0u, 0u, 0u, 0u);
    u32 two[4];
    for (u32 i = 0u; i < 4u; ++i) two[i] = 0u;
    const u32 first = (leaf.bottom + v) / a.lattice.cut_y * a.lattice.pixel_columns;
    u32 pixel = first + leaf.left / a.lattice.cut_x;
    u32 rest = leaf.left % a.lattice.cut_x;
    for (u32 u = 0u; u < LEAF_SIDE; ++u) {
        if (u < leaf.width) {
            const u32 mass = AT(masses, pixel / 2u) >> (pixel % 2u * 16u) & 0xffffu;
            two[u / 2u] = two[u / 2u] | mass << (u % 2u * 16u);
        }
        ++rest;
        pixel += rest == a.lattice.cut_x ? 1u : 0u;
        rest = rest == a.lattice.cut_x ? 0u : rest;
    }
    return U32X4(two[0], two[1], two[2], two[3]);
}

BODY void tell_owners(MEMORY const LeafArguments a, const Leaf leaf, const u32 v, const u32 slot,
                      const u32x4 row, const u32x2 won) {
    for (u32 u = 0u; u < leaf.width; ++u) {
        const u32 two = u < 2u ? row.x : u < 4u ? row.y : u < 6u ? row.z : row.w;
        if ((two >> (u % 2u * 16u) & 0xffffu) == 0u) continue;
        const u32 rank = (u < 4u ? won.x : won.y) >> (u % 4u * 8u) & 0xffu;
        AT(owners, (leaf.bottom + v) * a.lattice.columns + leaf.left + u) =
            AT(rival_ids, slot + AT(ranked, slot + rank)).y / 4u;
    }
}

// winners[row] has a byte for each lattice point: the rank of who owns it.
BODY void own_row(MEMORY const LeafArguments a, const u32 row) {
    const u32 index = row / LEAF_SIDE;
    const u32 v = row % LEAF_SIDE;
    const u32 slot = index * RIVAL_ROOM;
    const Leaf leaf = leaf_at(ON a, index);
    const u32x4 masses_of = masses_of_row(ON a, leaf, v);
    AT(row_masses, row) = masses_of;
    const u32 count = AT(rival_counts, index);
    if (count == CROWDED) return;
    if (v >= leaf.height) {
        AT(winners, row) = U32X2(0u, 0u);
        return;
    }

    i64 least[LEAF_SIDE];
    u32 winner[LEAF_SIDE];
    for (u32 rank = 0u; rank < count; ++rank) {
        const u32x4 near = AT(rivals, slot + AT(ranked, slot + rank));
        const Rival rival = rival_of(to_i32(near.x), to_i32(near.y), join_words(near.z, near.w));
        const i64 slope = rival_slope(rival.dx, a.lattice.step_x);
        i64 value = rival_value(rival, 0u, v * a.lattice.step_y);
        for (u32 u = 0u; u < LEAF_SIDE; ++u) {
            const bool is_less = rank == 0u || value < least[u];
            least[u] = is_less ? value : least[u];
            winner[u] = is_less ? rank : winner[u];
            value += slope;
        }
    }
    const u32x2 won = U32X2(winner[0] | winner[1] << 8 | winner[2] << 16 | winner[3] << 24,
                            winner[4] | winner[5] << 8 | winner[6] << 16 | winner[7] << 24);
    AT(winners, row) = won;
    if (a.is_telling != 0u) tell_owners(ON a, leaf, v, slot, masses_of, won);
}

BODY void serve_own(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count * LEAF_SIDE);
    for (u32 row = item * a.chunk; row < end; ++row) own_row(ON a, row);
}

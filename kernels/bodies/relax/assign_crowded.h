// The body of assign_crowded, for leaves with more rivals than there is memory for. Each lattice
// point is assigned alone: its owner is searched among all sites, and gets its mass at once.
#include "bodies/relax/leaf.h"
#include "bodies/relax/owner_of.h"
#include "bodies/relax/shares.h"

BODY void assign_crowded_point(MEMORY const LeafArguments a, const u32 number, const u32 u,
                               const u32 v) {
    const u32 stored =
        AT(masses, v / a.lattice.cut_y * a.lattice.pixel_columns + u / a.lattice.cut_x);
    if (stored == 0u) return;
    const u64 in_leaf = mass_in_leaf(stored, AT(exponents, number));
    const u64 mass = in_leaf << AT(exponents, number);
    const u32 owner = owner_of(ON a, AT(hints, number), lattice_place(u, a.lattice.step_x),
                               lattice_place(v, a.lattice.step_y));
    const Site site = LOAD(Site, sites, owner);
    add_to_share(
        ON owner, 1u, mass,
        mass * moment_offset(u, site.x, a.lattice.step_x, a.lattice.columns, a.lattice.period_x),
        mass * moment_offset(v, site.y, a.lattice.step_y, a.lattice.rows, a.lattice.period_y));
    if (a.is_telling != 0u) AT(owners, v * a.lattice.columns + u) = AT(indices, owner);
}

// The launch's units are leaves. An item serves rows of them.
BODY void serve_assign_crowded(MEMORY const LeafArguments a, const u32 item) {
    const u32 end = min((item + 1u) * a.chunk, a.count * LEAF_SIDE);
    for (u32 row = item * a.chunk; row < end; ++row) {
        const Area leaf = unit_at(ON a, row / LEAF_SIDE);
        const u32 v = row % LEAF_SIDE;
        if (v >= leaf.height) continue;
        const u32 number = number_of_leaf(a, leaf);
        for (u32 u = 0u; u < leaf.width; ++u)
            assign_crowded_point(ON a, number, leaf.left + u, leaf.bottom + v);
    }
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}

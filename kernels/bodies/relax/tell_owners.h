// The body of tell_owners: writes down the owner of each lattice point with importance. It is apart
// from assign, because it is rarely needed and would cost time there on lavapipe.
#include "bodies/relax/leaf.h"
#include "bodies/relax/place.h"
#include "bodies/relax/unit_leaves.h"

// The order of the rival to which lattice point (u, v) of the leaf belongs.
BODY u32 order_of_owner(MEMORY const Place place, const i32 u, const i32 v) {
    i32 least = 0x7fffffff;
    u32 owner = 0xffffffffu;
    for (u32 i = 0u; i < place.count; ++i) {
        const Near near = near_at(ON place, i);
        const i32 value = near.at + v * near.along_y + u * near.along_x;
        const bool is_less = value < least || (value == least && near.order < owner);
        least = is_less ? value : least;
        owner = is_less ? near.order : owner;
    }
    return owner;
}

// An item serves rows of leaves.
BODY void serve_tell_owners(MEMORY const LeafArguments a, const u32 item) {
    const u32 rows = a.side * a.side * LEAF_SIDE;
    const u32 end = min((item + 1u) * a.chunk, a.count * rows);
    for (u32 row = item * a.chunk; row < end; ++row) {
        const u32 index = row / rows;
        const u32 i = row % rows / LEAF_SIDE;
        const u32 v = row % LEAF_SIDE;
        if ((leaves_of_unit(ON a, index) >> i & 1u) == 0u) continue;
        const Area unit = unit_at(ON a, index);
        const Area leaf = leaf_of(a, unit, i);
        const Place place = place_of(ON unit, leaf, index);
        if (place.count == CROWDED || v >= leaf.height) continue;
        const u32 pixels = (leaf.bottom + v) / a.lattice.cut_y * a.lattice.pixel_columns;
        for (u32 u = 0u; u < leaf.width; ++u)
            if (AT(masses, pixels + (leaf.left + u) / a.lattice.cut_x) != 0u)
                AT(owners, (leaf.bottom + v) * a.lattice.columns + leaf.left + u) =
                    order_of_owner(ON place, to_i32(u), to_i32(v)) / 16u;
    }
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}

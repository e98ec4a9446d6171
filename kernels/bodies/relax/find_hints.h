// The body of find_hints: finds a site near each leaf's middle, whose power bounds the search for
// rivals. After the first iteration the winner of the middle is the hint (assign.h).
#include "bodies/relax/leaf.h"
#include "bodies/relax/nodes.h"
#include "bodies/relax/owner_of.h"
#include "bodies/relax/unit_leaves.h"

// Goes down the tree, always to the child that may be the nearest.
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

BODY void serve_find_hints(MEMORY const LeafArguments a, const u32 item) {
    const u32 leaves = a.side * a.side;
    const u32 end = min((item + 1u) * a.chunk, a.count * leaves);
    for (u32 i = item * a.chunk; i < end; ++i) {
        const u32 index = i / leaves;
        if ((leaves_of_unit(ON a, index) >> i % leaves & 1u) == 0u) continue;
        const Area leaf = leaf_of(a, unit_at(ON a, index), i % leaves);
        const u32 number = number_of_leaf(a, leaf);
        const u32 near = site_near(ON a, rect_of(a, leaf, 1u, 1u));
        AT(hints, number) =
            owner_of(ON a, near, lattice_place(leaf.left + leaf.width / 2u, a.lattice.step_x),
                     lattice_place(leaf.bottom + leaf.height / 2u, a.lattice.step_y));
    }
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}

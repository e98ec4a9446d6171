// The least power that sites of a node of the tree can have in a rectangle of the lattice.
#include "bodies/relax/site.h"
#include "portable/site_tree.h"

BODY u64 power_of_node(MEMORY const u32 index, const Rect box) {
    const Bounds node = LOAD(Bounds, node_boxes, index);
    return least_power(to_i32(node.low_x), to_i32(node.low_y), to_i32(node.high_x),
                       to_i32(node.high_y), number_of(LOAD(Wide, node_weights, index)), box);
}

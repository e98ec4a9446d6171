// The least power that sites of a node of the tree can have in a rectangle of the lattice.
#include "portable/site_tree.h"

BODY u64 power_of_node(MEMORY const u32 index, const Rect box) {
    const u32x4 node = AT(node_boxes, index);
    const u32x2 weight = AT(node_weights, index);
    return least_power(to_i32(node.x), to_i32(node.y), to_i32(node.z), to_i32(node.w),
                       join_words(weight.x, weight.y), box);
}

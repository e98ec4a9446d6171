// A leaf of the lattice, and its masses. Leaves with importance are listed by their numbers, which
// count them row by row; those of a launch are a batch.
#include "portable/power.h"
#include "portable/site_tree.h"

// Its lowest lattice point, and how many columns and rows of it lie on the lattice.
struct Leaf {
    u32 left;
    u32 bottom;
    u32 width;
    u32 height;
};
LACUNA_TYPEDEF(Leaf)

BODY Leaf leaf_at(MEMORY const LeafArguments a, const u32 index) {
    const u32 number = AT(leaves, a.first_leaf + index);
    Leaf leaf;
    leaf.left = number % a.leaf_columns * LEAF_SIDE;
    leaf.bottom = number / a.leaf_columns * LEAF_SIDE;
    leaf.width = min(a.lattice.columns - leaf.left, LEAF_SIDE);
    leaf.height = min(a.lattice.rows - leaf.bottom, LEAF_SIDE);
    return leaf;
}

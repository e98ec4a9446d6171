// The leaves of a unit that are served.

// Bit i is set if leaf i of the unit has importance. Leaves without any may lie outside the
// lattice.
BODY u32 leaves_of_unit(MEMORY const LeafArguments a, const u32 index) {
    return a.side == 1u ? 1u : AT(tile_leaves, a.first_unit + index);
}

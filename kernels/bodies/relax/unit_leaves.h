// Which leaves of a unit are served.

// Bit i tells whether leaf i of the unit has importance: those that have none may lie off the
// lattice.
BODY u32 leaves_of_unit(MEMORY const LeafArguments a, const u32 index) {
    return a.side == 1u ? 1u : AT(tile_leaves, a.first_unit + index);
}

// The kernels of relax: arguments and buffers, as those of kernels.h.
#ifndef LACUNA_PORTABLE_RELAX_KERNELS_H
#define LACUNA_PORTABLE_RELAX_KERNELS_H
#include "power.h"

LACUNA_BEGIN

// Of kernels that serve a batch of units, squares of side x side leaves: tiles, or single leaves. A
// leaf has 8 x 8 lattice points.
struct LeafArguments {
    u32 first_item;
    u32 chunk;
    RelaxLattice lattice;
    u32 first_unit;    // of the batch
    u32 count;         // of units in it
    u32 side;          // of a unit, in leaves
    u32 unit_columns;  // of the lattice
    u32 leaf_columns;
    u32 depth;       // of the tree of sites
    u32 is_telling;  // of assign_crowded: 1 where owners are written down
};
LACUNA_TYPEDEF(LeafArguments)

// Of kernels that serve the samples' sites, or the nodes of a level over them.
struct SiteArguments {
    u32 first_item;
    u32 chunk;
    RelaxLattice lattice;
    u32 level;
    u32 level_begin;  // where it is stored
};
LACUNA_TYPEDEF(SiteArguments)

LACUNA_END

// Of a tile, in leaves: its list of rivals is short enough for a leaf to look at all of it.
#define TILE_SIDE 4u
// A unit has room for so many rivals, a leaf for so many that may win in it, and slots so many of
// everything. A leaf that needs more, or is in a unit that does, is left for later.
#define RIVAL_ROOM 256u
#define WINNER_ROOM 64u
#define CROWDED 0xffffffffu

// A site is x, y, weight; a rival is by how much it lags behind another in its unit, and its order
// among ties. A rival's id is its site and image, 16 site + 3 y + x. Hints are of all leaves of the
// lattice, `winners` numbers of rivals.
// clang-format off
#define LEVEL_SITES_BINDINGS(B)                                                    \
    B(0, BOTH, u32x4, sites) B(1, BOTH, u32x4, node_boxes)                          \
    B(2, BOTH, u32x2, node_weights) B(3, READ, u32, least)
#define FIND_HINTS_BINDINGS(B)                                                      \
    B(0, READ, u32x4, sites) B(1, READ, u32x4, node_boxes)                          \
    B(2, READ, u32x2, node_weights) B(3, READ, u32, units) B(4, READ, u32, tile_leaves) \
    B(5, READ, u32, indices) B(6, WRITE, u32, hints) B(7, SHARED, u32, failure)
#define FIND_RIVALS_BINDINGS(B)                                                     \
    B(0, READ, u32x4, sites) B(1, READ, u32x4, node_boxes)                          \
    B(2, READ, u32x2, node_weights) B(3, READ, u32, units) B(4, READ, u32, tile_leaves) \
    B(5, READ, u32, indices) B(6, READ, u32, hints) B(7, WRITE, u32x4, rivals)      \
    B(8, WRITE, u32, rival_ids) B(9, WRITE, u32, rival_counts) B(10, WRITE, u32, late) \
    B(11, SHARED, u32, late_count) B(12, SHARED, u32, failure)
#define ASSIGN_BINDINGS(B)                                                             \
    B(0, READ, u32x4, sites) B(1, READ, u32, units) B(2, READ, u32, tile_leaves)    \
    B(3, WRITE, u32, hints) B(4, READ, u32x4, rivals) B(5, READ, u32, rival_ids)    \
    B(6, READ, u32, rival_counts) B(7, BOTH, u32, winners) B(8, READ, u32, masses)  \
    B(9, SHARED, u32, shares) B(10, SHARED, u32, moments) B(11, WRITE, u32, late)   \
    B(12, SHARED, u32, late_count) B(13, SHARED, u32, failure)
#define TELL_OWNERS_BINDINGS(B)                                                     \
    B(0, READ, u32, units) B(1, READ, u32, tile_leaves) B(2, READ, u32x4, rivals)   \
    B(3, READ, u32, rival_counts) B(4, READ, u32, masses) B(5, WRITE, u32, owners)  \
    B(6, SHARED, u32, failure)
#define ASSIGN_CROWDED_BINDINGS(B)                                                     \
    B(0, READ, u32x4, sites) B(1, READ, u32x4, node_boxes)                          \
    B(2, READ, u32x2, node_weights) B(3, READ, u32, units) B(4, READ, u32, indices)   \
    B(5, READ, u32, hints) B(6, READ, u32, masses) B(7, SHARED, u32, shares)        \
    B(8, SHARED, u32, moments) B(9, WRITE, u32, owners) B(10, SHARED, u32, failure)
#define MOVE_BINDINGS(B)                                                          \
    B(0, BOTH, u32x4, sites) B(1, READ, u32, shares) B(2, READ, u32, moments)       \
    B(3, SHARED, u32, least)
#define FIND_LEAST_BINDINGS(B) B(0, READ, u32x4, sites) B(1, SHARED, u32, least)

#define LACUNA_RELAX_BUFFERS(B)                                                                 \
    B(u32x4, sites) B(u32x4, node_boxes) B(u32x2, node_weights) B(u32, least) B(u32, units)       \
    B(u32, tile_leaves) B(u32, indices) B(u32, hints) B(u32x4, rivals) B(u32, rival_ids)        \
    B(u32, rival_counts) B(u32, winners) B(u32, masses) B(u32, owners) B(u32, shares)           \
    B(u32, moments) B(u32, late) B(u32, late_count)

#define LACUNA_RELAX_KERNELS(K)                             \
    K(level_sites, SiteArguments, LEVEL_SITES_BINDINGS)     \
    K(find_hints, LeafArguments, FIND_HINTS_BINDINGS)       \
    K(find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)     \
    K(assign, LeafArguments, ASSIGN_BINDINGS)                     \
    K(tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)     \
    K(assign_crowded, LeafArguments, ASSIGN_CROWDED_BINDINGS)     \
    K(move, SiteArguments, MOVE_BINDINGS)               \
    K(find_least, SiteArguments, FIND_LEAST_BINDINGS)
// clang-format on

#endif

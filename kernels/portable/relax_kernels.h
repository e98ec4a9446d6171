// The kernels of relax: arguments and buffers, in the form of kernels.h.
#ifndef LACUNA_PORTABLE_RELAX_KERNELS_H
#define LACUNA_PORTABLE_RELAX_KERNELS_H
#include "elements.h"
#include "gaussian.h"
#include "power.h"

LACUNA_BEGIN

// Arguments of kernels that serve a batch of units: squares of side x side leaves, which are tiles
// or single leaves. A leaf has 8 x 8 lattice points.
struct LeafArguments {
    u32 first_item;
    u32 chunk;
    RelaxLattice lattice;
    u32 first_unit;    // index of the batch's first unit
    u32 count;         // number of units in the batch
    u32 side;          // leaves along a unit's side
    u32 unit_columns;  // units along a row of the lattice
    u32 leaf_columns;
    u32 depth;       // level of the root of the tree over the sites
    u32 is_telling;  // in assign_crowded: 1 if owners are written down
};
LACUNA_TYPEDEF(LeafArguments)

// Arguments of kernels that serve the sites, or the nodes of a level of the tree.
struct SiteArguments {
    u32 first_item;
    u32 chunk;
    RelaxLattice lattice;
    u32 level;
    u32 level_begin;  // index at which the level begins
    u32 depth;        // level of the root
    u32 way;          // of a move, in 256ths
};
LACUNA_TYPEDEF(SiteArguments)

// Arguments of kernels that serve the samples of the Gaussian energy's descent.
struct DescentArguments {
    u32 first_item;
    u32 chunk;
    GaussianDomain domain;
    u32 pace;
    u32 block_bits;  // counts of cells are summed in blocks of 2^block_bits cells
};
LACUNA_TYPEDEF(DescentArguments)

LACUNA_END

// Leaves along a tile's side. At this size each leaf can look at the tile's whole list of rivals.
#define TILE_SIDE 4u
// Most rivals of a unit, and most of its rivals that may win in one leaf. Each unit has memory for
// RIVAL_ROOM rivals. A leaf that exceeds a limit, or whose unit does, is processed later.
#define RIVAL_ROOM 256u
#define WINNER_ROOM 64u
#define CROWDED 0xffffffffu

// The id of a rival, 16 site + 3 y + x, names its site and image. Hints are for all leaves of the
// lattice; `exponents` are those of the masses in each leaf; `winners` are numbers of rivals.
// `limited` are sites with the weights that they may have.
// clang-format off
#define LEVEL_SITES_BINDINGS(B) B(0, BOTH, Site, sites) B(1, BOTH, Bounds, node_boxes)          \
    B(2, BOTH, Wide, node_weights)
#define FIND_HINTS_BINDINGS(B) B(0, READ, Site, sites) B(1, READ, Bounds, node_boxes)           \
    B(2, READ, Wide, node_weights) B(3, READ, u32, units) B(4, READ, u32, tile_leaves)          \
    B(5, READ, u32, indices) B(6, WRITE, u32, hints) B(7, SHARED, u32, report)
#define FIND_RIVALS_BINDINGS(B) B(0, READ, Site, sites) B(1, READ, Bounds, node_boxes)          \
    B(2, READ, Wide, node_weights) B(3, READ, u32, units) B(4, READ, u32, tile_leaves)          \
    B(5, READ, u32, indices) B(6, READ, u32, hints) B(7, WRITE, ShortLag, rivals)               \
    B(8, WRITE, u32, rival_ids) B(9, WRITE, u32, rival_counts) B(10, WRITE, u32, late)          \
    B(11, SHARED, u32, late_count) B(12, SHARED, u32, report)
#define ASSIGN_BINDINGS(B) B(0, READ, Site, sites) B(1, READ, u32, units)                       \
    B(2, READ, u32, tile_leaves) B(3, WRITE, u32, hints) B(4, READ, ShortLag, rivals)           \
    B(5, READ, u32, rival_ids) B(6, READ, u32, rival_counts) B(7, BOTH, u32, winners)           \
    B(8, READ, u32, masses) B(9, READ, u32, exponents) B(10, SHARED, u32, shares)               \
    B(11, SHARED, u32, moments) B(12, WRITE, u32, late) B(13, SHARED, u32, late_count)          \
    B(14, SHARED, u32, report)
#define TELL_OWNERS_BINDINGS(B) B(0, READ, u32, units) B(1, READ, u32, tile_leaves)             \
    B(2, READ, ShortLag, rivals) B(3, READ, u32, rival_counts) B(4, READ, u32, masses)          \
    B(5, WRITE, u32, owners) B(6, SHARED, u32, report)
#define ASSIGN_CROWDED_BINDINGS(B) B(0, READ, Site, sites) B(1, READ, Bounds, node_boxes)       \
    B(2, READ, Wide, node_weights) B(3, READ, u32, units) B(4, READ, u32, indices)              \
    B(5, READ, u32, hints) B(6, READ, u32, masses) B(7, READ, u32, exponents)                   \
    B(8, SHARED, u32, shares) B(9, SHARED, u32, moments) B(10, WRITE, u32, owners)              \
    B(11, SHARED, u32, report)
#define LIMIT_BINDINGS(B) B(0, READ, Site, sites) B(1, READ, Bounds, node_boxes)                \
    B(2, BOTH, Site, limited) B(3, SHARED, u32, report)
#define MOVE_BINDINGS(B) B(0, BOTH, Site, sites) B(1, READ, u32, shares)                        \
    B(2, READ, u32, moments) B(3, READ, u32, masses)
// The id of a mover is its sample's number.
#define FIND_CELLS_BINDINGS(B) B(0, READ, Mover, movers) B(1, SHARED, u32, counts)              \
    B(2, WRITE, u32, ranks)
#define SORT_INTO_CELLS_BINDINGS(B) B(0, READ, Mover, movers) B(1, READ, u32, mover_ids)        \
    B(2, READ, u32, ranks) B(3, READ, u32, counts) B(4, READ, u32, sums) B(5, READ, u32, tops)  \
    B(6, WRITE, Mover, sorted_movers) B(7, WRITE, u32, sorted_ids)
#define DESCEND_BINDINGS(B) B(0, READ, Mover, sorted_movers) B(1, READ, u32, sorted_ids)        \
    B(2, READ, u32, counts) B(3, READ, u32, sums) B(4, READ, u32, tops) B(5, READ, u32, weights)\
    B(6, READ, u32, edges) B(7, READ, u32, column_reaches) B(8, WRITE, Mover, movers)           \
    B(9, WRITE, u32, mover_ids) B(10, SHARED, u32, report)

#define LACUNA_RELAX_BUFFERS(B)                                                                 \
    B(Site, sites) B(Bounds, node_boxes) B(Wide, node_weights) B(u32, units) B(u32, tile_leaves)\
    B(u32, indices) B(u32, hints) B(ShortLag, rivals) B(u32, rival_ids) B(u32, rival_counts)    \
    B(u32, winners) B(u32, masses) B(u32, exponents) B(u32, owners) B(u32, shares)              \
    B(u32, moments) B(u32, late) B(u32, late_count) B(Site, limited) B(Mover, movers)           \
    B(u32, mover_ids) B(u32, ranks) B(Mover, sorted_movers) B(u32, sorted_ids) B(u32, weights)  \
    B(u32, edges) B(u32, column_reaches)

#define LACUNA_RELAX_KERNELS(K)                             \
    K(level_sites, SiteArguments, LEVEL_SITES_BINDINGS)                                         \
    K(find_hints, LeafArguments, FIND_HINTS_BINDINGS)                                           \
    K(find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)                                         \
    K(assign, LeafArguments, ASSIGN_BINDINGS)                                                   \
    K(tell_owners, LeafArguments, TELL_OWNERS_BINDINGS)                                         \
    K(assign_crowded, LeafArguments, ASSIGN_CROWDED_BINDINGS)                                   \
    K(limit, SiteArguments, LIMIT_BINDINGS)                                                     \
    K(move, SiteArguments, MOVE_BINDINGS)                                                       \
    K(find_cells, DescentArguments, FIND_CELLS_BINDINGS)                                        \
    K(sort_into_cells, DescentArguments, SORT_INTO_CELLS_BINDINGS)                              \
    K(descend, DescentArguments, DESCEND_BINDINGS)
// clang-format on

#endif

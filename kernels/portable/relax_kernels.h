// The kernels of relax: arguments and buffers, as those of kernels.h.
#ifndef LACUNA_PORTABLE_RELAX_KERNELS_H
#define LACUNA_PORTABLE_RELAX_KERNELS_H
#include "power.h"

LACUNA_BEGIN

// Of kernels that serve a batch of leaves, 8 x 8 lattice points each, or rows or rivals of them.
struct LeafArguments {
    u32 first_item;
    u32 chunk;
    RelaxLattice lattice;
    u32 first_leaf;  // of the batch
    u32 count;       // of leaves in it
    u32 leaf_columns;
    u32 depth;       // of the tree of sites
    u32 is_telling;  // 1 where owners are written down
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

// A leaf has room for so many rivals, and slots so many of everything. One with more is crowded.
#define RIVAL_ROOM 64u
#define CROWDED 0xffffffffu

// A site is x, y, lift; a rival dx, dy, lift from its leaf's lowest lattice point. A rival's id is
// its site and image, 16 site + 3 y + x, and its order among ties.
// clang-format off
#define LEVEL_SITES_BINDINGS(B)                                                    \
    B(0, BOTH, u32x4, sites) B(1, BOTH, u32x4, node_boxes)                          \
    B(2, BOTH, u32x2, node_lifts) B(3, READ, u32, least)
#define FIND_RIVALS_BINDINGS(B)                                                     \
    B(0, READ, u32x4, sites) B(1, READ, u32x4, node_boxes)                          \
    B(2, READ, u32x2, node_lifts) B(3, READ, u32, leaves) B(4, READ, u32, indices)  \
    B(5, BOTH, u32, hints) B(6, BOTH, u32x4, rivals) B(7, BOTH, u32x2, rival_ids)   \
    B(8, BOTH, u32, ranked) B(9, WRITE, u32, rival_counts) B(10, SHARED, u32, failure)
#define OWN_BINDINGS(B)                                                             \
    B(0, READ, u32, leaves) B(1, READ, u32x4, rivals) B(2, READ, u32x2, rival_ids)  \
    B(3, READ, u32, ranked) B(4, READ, u32, rival_counts) B(5, READ, u32, masses)   \
    B(6, WRITE, u32x4, row_masses) B(7, WRITE, u32x2, winners)                      \
    B(8, WRITE, u32, owners)
#define OWN_CROWDED_BINDINGS(B)                                                     \
    B(0, READ, u32x4, sites) B(1, READ, u32x4, node_boxes)                          \
    B(2, READ, u32x2, node_lifts) B(3, READ, u32, leaves) B(4, READ, u32, indices)  \
    B(5, READ, u32, hints) B(6, READ, u32, rival_counts)                            \
    B(7, READ, u32x4, row_masses) B(8, SHARED, u32, shares) B(9, SHARED, u32, moments) \
    B(10, WRITE, u32, owners) B(11, SHARED, u32, failure)
#define GATHER_SHARES_BINDINGS(B)                                                   \
    B(0, READ, u32x4, sites) B(1, READ, u32, leaves) B(2, READ, u32x2, rival_ids)   \
    B(3, READ, u32, ranked) B(4, READ, u32, rival_counts)                           \
    B(5, READ, u32x4, row_masses) B(6, READ, u32x2, winners)                        \
    B(7, SHARED, u32, shares) B(8, SHARED, u32, moments)
#define SETTLE_BINDINGS(B)                                                          \
    B(0, BOTH, u32x4, sites) B(1, READ, u32, shares) B(2, READ, u32, moments)       \
    B(3, SHARED, u32, least)
#define FIND_LEAST_BINDINGS(B) B(0, READ, u32x4, sites) B(1, SHARED, u32, least)

#define LACUNA_RELAX_BUFFERS(B)                                                                 \
    B(u32x4, sites) B(u32x4, node_boxes) B(u32x2, node_lifts) B(u32, least) B(u32, leaves)      \
    B(u32, indices) B(u32, hints) B(u32x4, rivals) B(u32x2, rival_ids) B(u32, ranked)           \
    B(u32, rival_counts) B(u32, masses) B(u32x4, row_masses) B(u32x2, winners) B(u32, owners)   \
    B(u32, shares) B(u32, moments)

#define LACUNA_RELAX_KERNELS(K)                             \
    K(level_sites, SiteArguments, LEVEL_SITES_BINDINGS)     \
    K(find_rivals, LeafArguments, FIND_RIVALS_BINDINGS)     \
    K(own, LeafArguments, OWN_BINDINGS)                     \
    K(own_crowded, LeafArguments, OWN_CROWDED_BINDINGS)     \
    K(gather_shares, LeafArguments, GATHER_SHARES_BINDINGS) \
    K(settle, SiteArguments, SETTLE_BINDINGS)               \
    K(find_least, SiteArguments, FIND_LEAST_BINDINGS)
// clang-format on

#endif

// The kernels' arguments and buffers, each declared once for the host, OpenCL C and GLSL.
//
// A kernel X takes one struct of arguments and the buffers of X_BINDINGS: (number, access, type,
// name). `first_item` is the first item of a launch. `chunk` is the number of units of work that an
// item serves: many on a processor, 1 on a graphics card.
#ifndef LACUNA_PORTABLE_KERNELS_H
#define LACUNA_PORTABLE_KERNELS_H
#include "elements.h"
#include "relax_kernels.h"

LACUNA_BEGIN

// Members that the host does not set are 0.
#ifdef __cplusplus
#define OR_ZERO = 0
#else
#define OR_ZERO
#endif

// What conflicts: two candidates on a line; samples in each other's disks; in each other's
// ellipses. Mode cells has a rule of its own.
#define RULE_OF_LINES 0u
#define RULE_OF_DISKS 1u
#define RULE_OF_ELLIPSES 2u

// The part of the plan that kernels need.
struct Geometry {
    u64 radius_squared;
    u32 radius;
    u32 width;
    u32 height;
    u32 period_x;  // the domain's width if it wraps, otherwise 0
    u32 period_y;  // the domain's height if it wraps, otherwise 0
    u32 lines;
    u32 strip_width;
    u32 columns;
    u32 capacity;  // most spans of a tile, or the number of words of a line's bits
    u32 rule;      // what conflicts: RULE_OF_LINES and so on
    u32 chord_margin;
    u32 grid_side;  // width of the sample grid's cells, see grid_of in device/layout.h
    u32 grid_columns;
    u32 grid_rows;
    u32 copy_bits;  // see class_copies.h
};
LACUNA_TYPEDEF(Geometry)

// A candidate that reaches more blocks than a loop may have turns (failure.h) visits the nodes of
// the tree of blocks in several launches.
#define NODES_AT_ONCE 0x4000u
#define ALL_NODES 0xffffffffu

// Arguments of kernels that serve the round's draws or candidates.
struct DrawArguments {
    u32 first_item OR_ZERO;
    u32 chunk;
    Geometry g;
    u32 first;  // the draws to serve are [first, count)
    u32 count;
    u32 pass OR_ZERO;        // only in admit
    u32 last_pass;           // admission is finished if report[last_pass] is 0
    u32 status OR_ZERO;      // in screen: the new status of candidates that are covered
    u32 rows OR_ZERO;        // number of pixels in a column of pixels
    u32 metric OR_ZERO;      // see metric.h
    u32 slices OR_ZERO;      // in cells: an item serves every slices-th line near its samples
    u32 most_reach OR_ZERO;  // samples that reach farther wait for the next launch
    u32 is_listed OR_ZERO;   // 1: serve the candidates in `todo` or `survivors`; screen lists
                             // candidates, and insert marks new_cells
    u32 room OR_ZERO;  // in reach: most visitors of blocks; in enlist: entries before the round;
                       // in insert_in_space: samples before the round
    u32 first_node OR_ZERO;  // in reach: of the NODES_AT_ONCE to visit, or ALL_NODES
};
LACUNA_TYPEDEF(DrawArguments)

// Arguments of kernels that serve columns of lines. An item serves one column.
struct ColumnArguments {
    u32 first_item OR_ZERO;
    u32 last_pass;
    Geometry g;
    u32 room OR_ZERO;  // most new boxes
};
LACUNA_TYPEDEF(ColumnArguments)

// Arguments of kernels that serve the tiles of lines. In lines and exact a line is divided into
// `tiles` tiles of equal height, the last of which may be lower, so that the loops over their spans
// are short. Tiles are numbered line by line. The spans of a slab, which is some lines, lie in one
// buffer. An item serves one tile, but in locate draws, and in sum_tiles one line.
struct SlabArguments {
    u32 first_item OR_ZERO;
    u32 chunk OR_ZERO;
    Geometry g;
    u32 first_tile OR_ZERO;  // the tiles to serve are [first_tile, end_tile)
    u32 end_tile OR_ZERO;
    u32 slab_begin OR_ZERO;  // the slab's first tile
    u32 to_begin OR_ZERO;    // in grow: the first tile of the slab to which spans are moved
    u32 larger OR_ZERO;      // in grow: the capacity of that slab
    u32 near_room OR_ZERO;   // most samples near a tile
    u32 first_draw OR_ZERO;  // in locate: the draws on these lines are [first_draw, end_draw)
    u32 end_draw OR_ZERO;
    u32 last_pass OR_ZERO;   // in collect and subtract
    u32 block_bits OR_ZERO;  // in unfold: counts are summed in blocks of 2^block_bits tiles; 0:
                             // boxes are only counted
    u32 tiles OR_ZERO;       // of a line
    u32 tile_height OR_ZERO;
};
LACUNA_TYPEDEF(SlabArguments)

// Arguments of kernels that serve active boxes. A box is cut into at most 2^strip_bits strips: see
// bodies/exact/strip.h.
struct StripArguments {
    u32 first_item OR_ZERO;
    u32 chunk;
    Geometry g;
    u32 boxes;
    u32 strip_bits;  // 0 if boxes are not halved
    u32 last_pass;
    u32 block_bits;              // counts are summed in blocks of 2^block_bits boxes
    u32 room;                    // most new boxes
    u32 first_recent;            // with lists: only samples from this entry on cut the boxes
    u32 own_begin;               // boxes with x in [own_begin, own_begin + own_width) are cut;
    u32 own_width;               // the others lie in the halo
    u64 least_to_split OR_ZERO;  // in space: smaller bins are not split
};
LACUNA_TYPEDEF(StripArguments)

struct ScanArguments {
    u32 first_item OR_ZERO;
    u32 count;       // number of values
    u32 block;       // values for each item
    u32 to OR_ZERO;  // where sums of blocks begin in sums[]
};
LACUNA_TYPEDEF(ScanArguments)

// Arguments of kernels that list the samples of a round.
struct SampleArguments {
    u32 first_item OR_ZERO;
    u32 chunk OR_ZERO;
    u32 draws;  // of the round
    u32 last_pass;
    u32 counts_before;  // number of counts[] before those of samples
    u32 block_bits;     // counts are summed in blocks of 2^block_bits
    u32 words_of_bin;   // words of results[] for each bin
    u32 bins;           // 0: as many as there are new boxes
    u32 room;           // most new boxes
};
LACUNA_TYPEDEF(SampleArguments)

LACUNA_END

// The bindings of each kernel. The elements of buffers are declared in elements.h.
// clang-format off
#define LOCATE_BINDINGS(B) B(0, READ, Span, spans) B(1, READ, u32, tile_begins)                 \
    B(2, READ, Draw, draws) B(3, WRITE, Candidate, candidates) B(4, WRITE, u32, statuses)       \
    B(5, SHARED, u32, report)
#define LOCATE_IN_BOXES_BINDINGS(B) B(0, READ, Box, boxes) B(1, READ, Draw, draws)              \
    B(2, WRITE, Candidate, candidates) B(3, WRITE, u32, statuses)
#define LOCATE_IN_CELLS_BINDINGS(B) B(0, READ, u32, bits) B(1, READ, Draw, draws)               \
    B(2, WRITE, Candidate, located) B(3, SHARED, u32, report)
#define SORT_COLUMNS_BINDINGS(B) B(0, READ, u32, column_begins) B(1, READ, Candidate, located)  \
    B(2, BOTH, u32, buckets) B(3, BOTH, Candidate, candidates) B(4, WRITE, u32, statuses)       \
    B(5, SHARED, u32, report)
#define LOOK_UP_RADII_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, column_of)  \
    B(2, READ, u32, row_of) B(3, READ, u32, pixel_radii) B(4, WRITE, u32, candidate_radii)
#define SCREEN_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, grid_x)            \
    B(2, READ, u32, grid_y) B(3, BOTH, u32, statuses) B(4, SHARED, u32, outcomes)               \
    B(5, SHARED, u32, report) B(6, SHARED, u32, cell_heads) B(7, WRITE, u32, next_candidates)
#define SCREEN_IN_CELLS_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, bits)     \
    B(2, BOTH, u32, statuses) B(3, SHARED, u32, outcomes) B(4, SHARED, u32, report)
#define ADMIT_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, SHARED, u32, statuses)         \
    B(2, SHARED, u32, report) B(3, SHARED, u32, outcomes) B(4, READ, u32, cell_heads)           \
    B(5, READ, u32, next_candidates)
#define ADMIT_IN_CELLS_BINDINGS(B) B(0, READ, u32, column_begins) B(1, READ, u32, buckets)      \
    B(2, READ, Candidate, candidates) B(3, SHARED, u32, statuses) B(4, SHARED, u32, report)     \
    B(5, SHARED, u32, outcomes) B(6, READ, u32, candidate_radii) B(7, READ, u32, column_of)     \
    B(8, READ, u32, row_of) B(9, READ, u32, pixel_reaches)
#define INSERT_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Candidate, candidates)          \
    B(2, READ, u32, statuses) B(3, WRITE, u32, grid_x) B(4, WRITE, u32, grid_y)                 \
    B(5, WRITE, u32, cell_heads) B(6, SHARED, u32, new_cells)
#define OPEN_LINES_BINDINGS(B) B(0, WRITE, Span, spans) B(1, WRITE, u32, span_counts)           \
    B(2, WRITE, u32, tile_lengths)
#define SUM_TILES_BINDINGS(B) B(0, READ, u32, tile_lengths) B(1, WRITE, u32, tile_begins)       \
    B(2, WRITE, u32, results)
#define COLLECT_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, u32, grid_x)                   \
    B(2, READ, u32, grid_y) B(3, READ, u32, new_cells) B(4, WRITE, Spot, near)                  \
    B(5, WRITE, u32, near_counts)
#define SUBTRACT_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Spot, near)                   \
    B(2, READ, u32, near_counts) B(3, BOTH, Span, spans) B(4, BOTH, u32, span_counts)           \
    B(5, BOTH, u32, tile_lengths)
#define GROW_BINDINGS(B) B(0, READ, u32, span_counts) B(1, READ, Span, spans)                   \
    B(2, WRITE, Span, new_spans)
#define UNFOLD_BINDINGS(B) B(0, READ, Span, spans) B(1, READ, u32, span_counts)                 \
    B(2, BOTH, u32, counts) B(3, READ, u32, sums) B(4, READ, u32, tops)                         \
    B(5, WRITE, Box, boxes) B(6, SHARED, u32, report)
#define CUT_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Box, boxes)                        \
    B(2, READ, u32, grid_x) B(3, READ, u32, grid_y) B(4, BOTH, u32, counts)                     \
    B(5, BOTH, Span, strip_pieces) B(6, WRITE, u32, results)
#define KEEP_BINDINGS(B) CUT_BINDINGS(B) B(7, READ, u32, sums) B(8, READ, u32, tops)            \
    B(9, WRITE, Box, new_boxes)
#define SCAN_BINDINGS(B) B(0, BOTH, u32, counts) B(1, WRITE, u32, sums)                         \
    B(2, SHARED, u32, report)
#define COUNT_SAMPLES_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, u32, outcomes)           \
    B(2, WRITE, u32, counts)
#define LIST_SAMPLES_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Candidate, candidates)    \
    B(2, READ, u32, statuses) B(3, READ, u32, outcomes) B(4, READ, u32, counts)                 \
    B(5, READ, u32, sums) B(6, READ, u32, tops) B(7, WRITE, u32, results)
#define FIND_BIN_BEGINS_BINDINGS(B) B(0, READ, Box, new_boxes) B(1, SHARED, u32, report)        \
    B(2, WRITE, u32, bin_begins)
#define SUBTRACT_IN_CELLS_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Candidate, candidates) \
    B(2, READ, u32, statuses) B(3, READ, u32, column_of) B(4, READ, u32, row_of)                \
    B(5, READ, u32, row_begins) B(6, READ, u32, pixel_radii) B(7, READ, u32, pixel_reaches)     \
    B(8, READ, u32, widest_rows) B(9, SHARED, u32, widest) B(10, SHARED, u32, bits)             \
    B(11, SHARED, u32, free_lengths) B(12, READ, u32, todo) B(13, WRITE, u32, left)

// Mode exact with a radius field. lists[] has the first entry of each block's list, and
// visitor_heads[] its first visitor. tree_boxes and tree_links are the nodes of plan/first_boxes.h.
// factors[MOST_CLASSES * a + b] is for samples of classes a and b (class_copies.h). The kernel split
// writes borders[] and strip_radii[].
#define LOCATE_WITH_FIELD_BINDINGS(B) B(0, READ, u32, axes) B(1, READ, Radii, radius_bounds)    \
    B(2, READ, u32, mask_nodes) B(3, READ, Box, boxes) B(4, READ, Origin, origins)              \
    B(5, READ, Draw, draws) B(6, WRITE, Candidate, candidates) B(7, WRITE, u32, candidate_radii)\
    B(8, WRITE, u32, statuses) B(9, SHARED, u32, report)
#define SCREEN_WITH_FIELD_BINDINGS(B) B(0, READ, Candidate, candidates)                         \
    B(1, READ, u32, candidate_radii) B(2, READ, u32, lists) B(3, READ, Neighbour, entries)      \
    B(4, BOTH, u32, statuses) B(5, SHARED, u32, outcomes) B(6, WRITE, u32, survivors)           \
    B(7, SHARED, u32, report) B(8, READ, Wide, factors) B(9, READ, u32, axes)                    \
    B(10, READ, Ellipse, ellipses)
#define REACH_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, candidate_radii)    \
    B(2, READ, u32, statuses) B(3, READ, Box, tree_boxes) B(4, READ, Links, tree_links)         \
    B(5, READ, BlockNode, node_of) B(6, SHARED, u32, report) B(7, SHARED, u32, visitor_heads)   \
    B(8, WRITE, Visitor, visitors) B(9, READ, u32, survivors) B(10, READ, Wide, factors)         \
    B(11, READ, u32, axes) B(12, READ, Ellipse, ellipses) B(13, READ, u32, open_parts)
#define ADMIT_WITH_FIELD_BINDINGS(B) B(0, READ, Candidate, candidates)                          \
    B(1, READ, u32, candidate_radii) B(2, SHARED, u32, statuses) B(3, READ, u32, visitor_heads) \
    B(4, READ, Visitor, visitors) B(5, SHARED, u32, report) B(6, SHARED, u32, outcomes)         \
    B(7, READ, Wide, factors) B(8, READ, u32, axes) B(9, READ, Ellipse, ellipses)
#define ENLIST_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Candidate, candidates)          \
    B(2, READ, u32, candidate_radii) B(3, READ, u32, statuses) B(4, READ, u32, visitor_heads)   \
    B(5, READ, Visitor, visitors) B(6, WRITE, Neighbour, entries) B(7, BOTH, u32, lists)        \
    B(8, READ, BlockNode, node_of) B(9, READ, Box, tree_boxes) B(10, READ, Links, tree_links)   \
    B(11, READ, Wide, factors) B(12, SHARED, u32, open_parts)
#define SPLIT_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, u32, axes)                       \
    B(2, READ, Radii, radius_bounds) B(3, READ, u32, mask_nodes) B(4, READ, Box, boxes)         \
    B(5, READ, Origin, origins) B(6, WRITE, Borders, borders) B(7, WRITE, StripRadii, strip_radii)
#define CUT_WITH_FIELD_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Box, boxes)             \
    B(2, READ, Origin, origins) B(3, READ, u32, lists) B(4, READ, Neighbour, entries)           \
    B(5, READ, Borders, borders) B(6, READ, StripRadii, strip_radii) B(7, BOTH, u32, counts)    \
    B(8, BOTH, Span, strip_pieces) B(9, WRITE, Origin, new_origins) B(10, READ, Wide, factors)   \
    B(11, READ, u32, axes) B(12, READ, Ellipse, ellipses)
#define KEEP_WITH_FIELD_BINDINGS(B) CUT_WITH_FIELD_BINDINGS(B) B(13, READ, u32, sums)           \
    B(14, READ, u32, tops) B(15, WRITE, Box, new_boxes)
#define MEASURE_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, u32, axes)                     \
    B(2, READ, Radii, radius_bounds) B(3, READ, u32, mask_nodes) B(4, READ, Box, new_boxes)     \
    B(5, BOTH, Origin, new_origins)                                                             \
    B(6, WRITE, u32, results)

// Surfaces and volumes. Samples are in lists, one for each block of bins: sample_heads[] has the
// first, and listed[] all. blocks[] has the block of each bin.
#define LOCATE_IN_SPACE_BINDINGS(B) B(0, READ, Portion, portions) B(1, READ, u32, blocks)       \
    B(2, READ, Corner, corners) B(3, READ, u32, volume) B(4, READ, u32, near_begins)            \
    B(5, READ, u32, near_blocks) B(6, READ, Draw, draws) B(7, READ, u32, third_bits)            \
    B(8, WRITE, Candidate, candidates) B(9, WRITE, u32, heights) B(10, WRITE, u32, statuses)    \
    B(11, SHARED, u32, report)
#define SCREEN_IN_SPACE_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, heights)  \
    B(2, READ, u32, volume) B(3, READ, u32, near_begins) B(4, READ, u32, near_blocks)           \
    B(5, READ, u32, sample_heads) B(6, READ, Listed, listed) B(7, BOTH, u32, statuses)          \
    B(8, SHARED, u32, outcomes) B(9, SHARED, u32, report) B(10, SHARED, u32, cell_heads)        \
    B(11, WRITE, u32, next_candidates)
#define ADMIT_IN_SPACE_BINDINGS(B) B(0, READ, Candidate, candidates) B(1, READ, u32, heights)   \
    B(2, READ, u32, volume) B(3, READ, u32, near_begins) B(4, READ, u32, near_blocks)           \
    B(5, SHARED, u32, statuses) B(6, SHARED, u32, report) B(7, SHARED, u32, outcomes)           \
    B(8, READ, u32, cell_heads) B(9, READ, u32, next_candidates)
#define INSERT_IN_SPACE_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Candidate, candidates) \
    B(2, READ, u32, heights) B(3, READ, u32, statuses) B(4, WRITE, u32, cell_heads)             \
    B(5, SHARED, u32, sample_heads) B(6, WRITE, Listed, listed)
#define SPLIT_IN_SPACE_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Portion, portions)      \
    B(2, READ, u32, blocks) B(3, READ, Corner, corners) B(4, READ, u32, volume)                 \
    B(5, READ, u32, near_begins) B(6, READ, u32, near_blocks) B(7, READ, u32, sample_heads)     \
    B(8, READ, Listed, listed) B(9, WRITE, u32, kept_pieces) B(10, WRITE, u32, counts)
#define KEEP_IN_SPACE_BINDINGS(B) B(0, SHARED, u32, report) B(1, READ, Portion, portions)       \
    B(2, READ, u32, blocks) B(3, READ, Corner, corners) B(4, READ, u32, volume)                 \
    B(5, READ, u32, near_begins) B(6, READ, u32, near_blocks) B(7, READ, u32, kept_pieces)      \
    B(8, READ, u32, counts) B(9, READ, u32, sums) B(10, READ, u32, tops)                        \
    B(11, WRITE, Portion, new_portions) B(12, WRITE, u32, new_blocks) B(13, WRITE, u32, results)
#define LIST_SAMPLES_IN_SPACE_BINDINGS(B) LIST_SAMPLES_BINDINGS(B) B(8, READ, u32, heights)     \
    B(9, READ, u32, volume) B(10, READ, Draw, draws) B(11, READ, Portion, portions)             \
    B(12, READ, u32, near_begins) B(13, READ, u32, near_blocks)

// All buffers. A kernel has the buffers that its bindings name.
#define LACUNA_BUFFERS(B)                                                                       \
    B(Draw, draws) B(Candidate, located) B(u32, column_begins) B(u32, buckets)                  \
    B(Candidate, candidates) B(u32, statuses) B(u32, report) B(u32, outcomes) B(u32, results)   \
    B(u32, free_lengths) B(Span, spans) B(Span, new_spans) B(u32, span_counts)                  \
    B(u32, tile_lengths) B(u32, tile_begins) B(u32, cell_heads) B(u32, next_candidates)         \
    B(u32, new_cells) B(Spot, near) B(u32, near_counts) B(u32, grid_x) B(u32, grid_y)           \
    B(Box, boxes) B(Box, new_boxes) B(u32, counts) B(u32, sums) B(u32, tops)                    \
    B(Span, strip_pieces) B(u32, bin_begins) B(u32, bits) B(u32, widest) B(u32, widest_rows)    \
    B(u32, column_of) B(u32, row_of) B(u32, row_begins) B(u32, pixel_radii)                     \
    B(u32, pixel_reaches) B(u32, candidate_radii) B(u32, todo) B(u32, left) B(u32, axes)        \
    B(Radii, radius_bounds) B(u32, mask_nodes) B(Origin, origins) B(Origin, new_origins)        \
    B(Borders, borders) B(StripRadii, strip_radii) B(Box, tree_boxes) B(Links, tree_links)      \
    B(BlockNode, node_of) B(u32, visitor_heads) B(Visitor, visitors) B(u32, lists)              \
    B(Neighbour, entries) B(u32, survivors) B(Wide, factors) B(Ellipse, ellipses)                \
    B(u32, open_parts) B(Portion, portions) B(Portion, new_portions) B(u32, blocks)             \
    B(u32, new_blocks) B(Corner, corners) B(u32, volume) B(u32, near_begins)                    \
    B(u32, near_blocks) B(u32, sample_heads) B(Listed, listed) B(u32, heights)                  \
    B(u32, third_bits) B(u32, kept_pieces)                                                      \
    LACUNA_RELAX_BUFFERS(B)

// All kernels: name, arguments, bindings.
#define LACUNA_KERNELS(K)                                             \
    K(locate, SlabArguments, LOCATE_BINDINGS)                                                   \
    K(locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)                                 \
    K(locate_in_cells, SlabArguments, LOCATE_IN_CELLS_BINDINGS)                                 \
    K(sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)                                     \
    K(look_up_radii, DrawArguments, LOOK_UP_RADII_BINDINGS)                                     \
    K(screen, DrawArguments, SCREEN_BINDINGS)                                                   \
    K(screen_in_cells, DrawArguments, SCREEN_IN_CELLS_BINDINGS)                                 \
    K(admit, DrawArguments, ADMIT_BINDINGS)                                                     \
    K(admit_in_cells, DrawArguments, ADMIT_IN_CELLS_BINDINGS)                                   \
    K(insert, DrawArguments, INSERT_BINDINGS)                                                   \
    K(collect, SlabArguments, COLLECT_BINDINGS)                                                 \
    K(subtract, SlabArguments, SUBTRACT_BINDINGS)                                               \
    K(open_lines, SlabArguments, OPEN_LINES_BINDINGS)                                           \
    K(sum_tiles, SlabArguments, SUM_TILES_BINDINGS)                                             \
    K(grow, SlabArguments, GROW_BINDINGS)                                                       \
    K(unfold, SlabArguments, UNFOLD_BINDINGS)                                                   \
    K(cut, StripArguments, CUT_BINDINGS)                                                        \
    K(keep, StripArguments, KEEP_BINDINGS)                                                      \
    K(scan, ScanArguments, SCAN_BINDINGS)                                                       \
    K(count_samples, SampleArguments, COUNT_SAMPLES_BINDINGS)                                   \
    K(list_samples, SampleArguments, LIST_SAMPLES_BINDINGS)                                     \
    K(find_bin_begins, ColumnArguments, FIND_BIN_BEGINS_BINDINGS)                               \
    K(subtract_in_cells, DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)                             \
    K(locate_with_field, DrawArguments, LOCATE_WITH_FIELD_BINDINGS)                             \
    K(screen_with_field, DrawArguments, SCREEN_WITH_FIELD_BINDINGS)                             \
    K(reach, DrawArguments, REACH_BINDINGS)                                                     \
    K(admit_with_field, DrawArguments, ADMIT_WITH_FIELD_BINDINGS)                               \
    K(enlist, DrawArguments, ENLIST_BINDINGS)                                                   \
    K(split, StripArguments, SPLIT_BINDINGS)                                                    \
    K(cut_with_field, StripArguments, CUT_WITH_FIELD_BINDINGS)                                  \
    K(keep_with_field, StripArguments, KEEP_WITH_FIELD_BINDINGS)                                \
    K(measure, StripArguments, MEASURE_BINDINGS)                                                \
    K(locate_in_space, DrawArguments, LOCATE_IN_SPACE_BINDINGS)                                 \
    K(screen_in_space, DrawArguments, SCREEN_IN_SPACE_BINDINGS)                                 \
    K(admit_in_space, DrawArguments, ADMIT_IN_SPACE_BINDINGS)                                   \
    K(insert_in_space, DrawArguments, INSERT_IN_SPACE_BINDINGS)                                 \
    K(split_in_space, StripArguments, SPLIT_IN_SPACE_BINDINGS)                                  \
    K(keep_in_space, StripArguments, KEEP_IN_SPACE_BINDINGS)                                    \
    K(list_samples_in_space, SampleArguments, LIST_SAMPLES_IN_SPACE_BINDINGS)                   \
    LACUNA_RELAX_KERNELS(K)
// clang-format on

#endif

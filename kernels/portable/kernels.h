// The kernels' arguments and buffers, each named once for the host, OpenCL C and GLSL.
//
// A kernel X takes one struct of arguments and the buffers of X_BINDINGS: (number, access, type,
// name). `first_item` is the first item of a launch, and `chunk` how many of its units of work an
// item serves: many on a processor, 1 on a graphics card.
#ifndef LACUNA_PORTABLE_KERNELS_H
#define LACUNA_PORTABLE_KERNELS_H
#include "relax_kernels.h"

LACUNA_BEGIN

// What kernels need of the plan.
struct Geometry {
    u64 radius_squared;
    u32 radius;
    u32 width;
    u32 height;
    u32 period_x;  // the domain's width where it wraps, or 0
    u32 period_y;  // its height where it wraps, or 0
    u32 lines;
    u32 strip_width;
    u32 columns;
    u32 capacity;  // spans that a line has room for, or words of its bits
    u32 is_exact;  // 1 in mode exact, or 0
    u32 chord_margin;
    u32 grid_side;  // of the sample grid's cells, see plan/plan.h
    u32 grid_columns;
    u32 grid_rows;
};
LACUNA_TYPEDEF(Geometry)

// Of kernels that serve the round's draws or candidates.
struct DrawArguments {
    u32 first_item;
    u32 chunk;
    Geometry g;
    u32 count;       // of draws, or the end of those to serve
    u32 pass;        // of admit; elsewhere the last pass, which tells whether admission is settled;
                     // of screen: what becomes of candidates that are covered
    u32 rows;        // of pixels in a column of them
    u32 metric;      // see metric.h
    u32 slices;      // of subtract_in_cells: an item serves every slices-th line near its samples
    u32 most_reach;  // samples that reach farther are left for the next launch
    u32 is_listed;   // 1 where the candidates to serve are those of `todo` or `survivors`, which
                     // screen fills
    u32 first;       // of the draws to serve, which end at `count`
    u32 room;        // of reach: for visitors of blocks
};
LACUNA_TYPEDEF(DrawArguments)

// Of kernels that serve columns of lines, one an item.
struct ColumnArguments {
    u32 first_item;
    u32 last_pass;
    Geometry g;
    u32 room;  // of the new boxes
};
LACUNA_TYPEDEF(ColumnArguments)

// Of kernels that serve the lines [first_line, end_line), whose spans one slab holds.
struct SlabArguments {
    u32 first_item;
    u32 chunk;
    Geometry g;
    u32 first_line;
    u32 end_line;
    u32 slab_begin;  // the slab's first line
    u32 to_begin;    // of grow: the first line of the slab that spans are moved to
    u32 larger;      // of grow: the capacity there
    u32 first_draw;  // of locate: the draws of these lines are [first_draw, end_draw)
    u32 end_draw;
    u32 last_pass;    // of subtract
    u32 block_bits;   // of unfold: the counts of 2^block_bits lines have a sum of their own
    u32 is_counting;  // of unfold: 1 where boxes are only counted
};
LACUNA_TYPEDEF(SlabArguments)

// Of kernels that cut boxes into strips, `width` wide: each box is one, or two where is_halved
// is 1. With a radius field boxes are places of any width, see bodies/exact/strip.h.
struct StripArguments {
    u32 first_item;
    u32 chunk;
    Geometry g;
    u32 boxes;
    u32 is_halved;
    u32 width;
    u32 last_pass;
    u32 block_bits;    // the counts of 2^block_bits strips or places have a sum of their own
    u32 room;          // of the new boxes
    u32 first_recent;  // with a radius field: places are cut by the samples in their lists from
                       // this on
    u32 own_begin;     // boxes at other x than the own_width from there on belong to the halo
    u32 own_width;
};
LACUNA_TYPEDEF(StripArguments)

struct ScanArguments {
    u32 first_item;
    u32 count;  // of values
    u32 block;  // so many an item
};
LACUNA_TYPEDEF(ScanArguments)

LACUNA_END

// The bindings of each kernel. A draw is place, rank, offset, order; a candidate x, y, line, order.
// clang-format off
#define LOCATE_BINDINGS(B) B(0, READ, u32x2, spans) \
    B(1, READ, u32x4, draws) B(2, WRITE, u32x4, located) B(3, SHARED, u32, failure)
#define LOCATE_IN_BOXES_BINDINGS(B) B(0, READ, u32, box_x) \
    B(1, READ, u32, box_begin) B(2, READ, u32x4, draws) B(3, WRITE, u32x4, located)
#define LOCATE_IN_CELLS_BINDINGS(B) B(0, READ, u32, bits) \
    B(1, READ, u32x4, draws) B(2, WRITE, u32x4, located) B(3, SHARED, u32, failure)
#define SORT_COLUMNS_BINDINGS(B)                                                       \
    B(0, READ, u32, column_begins) B(1, READ, u32x4, located) B(2, BOTH, u32, buckets) \
    B(3, BOTH, u32x4, candidates) B(4, WRITE, u32, statuses) B(5, SHARED, u32, failure)
#define LOOK_UP_RADII_BINDINGS(B)                                                    \
    B(0, READ, u32x4, candidates) B(1, READ, u32, column_of) B(2, READ, u32, row_of) \
    B(3, READ, u32, pixel_radii) B(4, WRITE, u32, candidate_radii)
#define SCREEN_BINDINGS(B)                                                        \
    B(0, READ, u32x4, candidates) B(1, READ, u32, grid_x) B(2, READ, u32, grid_y) \
    B(3, BOTH, u32, statuses) B(4, WRITE, u32x2, samples)
#define SCREEN_ON_LINES_BINDINGS(B)                                                       \
    B(0, READ, u32x4, candidates) B(1, READ, u32x2, spans) B(2, READ, u32, span_counts) \
    B(3, BOTH, u32, statuses) B(4, WRITE, u32x2, samples)
#define SCREEN_IN_CELLS_BINDINGS(B)                                                  \
    B(0, READ, u32x4, candidates) B(1, READ, u32, bits) B(2, BOTH, u32, statuses)       \
    B(3, WRITE, u32x2, samples)
#define ADMIT_BINDINGS(B)                                                                    \
    B(0, READ, u32, column_begins) B(1, READ, u32, buckets) B(2, READ, u32x4, candidates)    \
    B(3, SHARED, u32, statuses) B(4, SHARED, u32, undecided) B(5, WRITE, u32x2, samples)        \
    B(6, SHARED, u32, failure)
#define ADMIT_IN_CELLS_BINDINGS(B)                                                \
    ADMIT_BINDINGS(B) B(7, READ, u32, candidate_radii) B(8, READ, u32, column_of) \
    B(9, READ, u32, row_of) B(10, READ, u32, pixel_reaches)
#define INSERT_BINDINGS(B)                                                          \
    B(0, READ, u32, undecided) B(1, READ, u32x4, candidates) B(2, READ, u32, statuses) \
    B(3, WRITE, u32, grid_x) B(4, WRITE, u32, grid_y)
#define COLLECT_BINDINGS(B)                                                                   \
    B(0, READ, u32, undecided) B(1, READ, u32, column_begins) B(2, READ, u32, near_begins)   \
    B(3, READ, u32x4, candidates) B(4, READ, u32, statuses) B(5, WRITE, u32, near_counts)       \
    B(6, WRITE, u32x2, near) B(7, SHARED, u32, failure)
#define SUBTRACT_BINDINGS(B)                                                                 \
    B(0, READ, u32, undecided) B(1, READ, u32, near_begins) B(2, READ, u32, near_counts)     \
    B(3, READ, u32x2, near) B(4, BOTH, u32x2, spans) B(5, BOTH, u32, span_counts)            \
    B(6, BOTH, u32, free_lengths) B(7, SHARED, u32, overflow) B(8, SHARED, u32, failure)
#define GROW_BINDINGS(B) \
    B(0, READ, u32, span_counts) B(1, READ, u32x2, spans) B(2, WRITE, u32x2, new_spans)
#define UNFOLD_BINDINGS(B)                                                                   \
    B(0, READ, u32x2, spans) B(1, READ, u32, span_counts) B(2, BOTH, u32, counts)            \
    B(3, READ, u32, sums) B(4, WRITE, u32, box_x) B(5, WRITE, u32, box_begin)                \
    B(6, WRITE, u32, box_end) B(7, SHARED, u32, failure)
#define CUT_BINDINGS(B)                                                                      \
    B(0, READ, u32, undecided) B(1, READ, u32, grid_x) B(2, READ, u32, grid_y)               \
    B(3, READ, u32, box_x) B(4, READ, u32, box_begin) B(5, READ, u32, box_end)               \
    B(6, SHARED, u32, failure) B(7, BOTH, u32, counts) B(8, BOTH, u32, piece_begin)          \
    B(9, BOTH, u32, piece_end)
#define KEEP_BINDINGS(B)                                                                     \
    CUT_BINDINGS(B) B(10, READ, u32, sums) B(11, WRITE, u32, new_x)                          \
    B(12, WRITE, u32, new_begin) B(13, WRITE, u32, new_end) B(14, WRITE, u32, free_lengths)
#define SCAN_BINDINGS(B) \
    B(0, BOTH, u32, counts) B(1, WRITE, u32, sums) B(2, SHARED, u32, failure)
#define FIND_BIN_BEGINS_BINDINGS(B) \
    B(0, READ, u32, new_x) B(1, READ, u32, total) B(2, WRITE, u32, bin_begins)
#define SUBTRACT_IN_CELLS_BINDINGS(B)                                                        \
    B(0, READ, u32, undecided) B(1, READ, u32x4, candidates) B(2, READ, u32, statuses)          \
    B(3, READ, u32, column_of) B(4, READ, u32, row_of) B(5, READ, u32, row_begins)           \
    B(6, READ, u32, pixel_radii) B(7, READ, u32, pixel_reaches)                              \
    B(8, READ, u32, widest_rows) B(9, SHARED, u32, widest) B(10, SHARED, u32, bits)          \
    B(11, SHARED, u32, free_lengths) B(12, READ, u32, todo) B(13, WRITE, u32, left)          \
    B(14, SHARED, u32, left_count) B(15, SHARED, u32, failure)

// Mode exact with a radius field. A place is x, width, begin, end; an entry of a list x, y, radius and the
// number of the next one. For each block lists[] has its first entry; for each place origins[] has
// its block, and the least radius under it, with IS_EVEN where there is no other
// (portable/radius_field.h), or 0 where that is not known. node_links are the greatest radius, and the
// next node, first block and whole of plan/first_boxes.h. A visitor of a block is a candidate that
// reaches it, and the number of the next visitor. pieces[] are begin and end of what is left of a
// place and, if something inside of that is missing, of what is; or of what is left of each half,
// and more_pieces[] of what is missing inside; or, where a place lies on unlike pixels, of what is
// left of the strips of its left half, and more_pieces[] of its right half. uneven[] and
// new_uneven[] are the places without IS_EVEN; strips[] and strip_radii[] have four entries for
// each of uneven[]. several[] are the places of which there may be more pieces than that, and where
// in uneven[] each is, if it is there. widths[] and free_lengths[] are those of the new places, for
// the host.
#define LOCATE_WITH_FIELD_BINDINGS(B) B(0, READ, u32, axes)                                   \
    B(1, READ, u32x2, radius_bounds) B(2, READ, u32, mask_bits) B(3, READ, u32x4, places)    \
    B(4, READ, u32x2, origins) B(5, READ, u32x4, draws) B(6, WRITE, u32x4, candidates)        \
    B(7, WRITE, u32, candidate_radii) B(8, WRITE, u32, statuses) B(9, SHARED, u32, failure)
#define SCREEN_WITH_FIELD_BINDINGS(B)                                                         \
    B(0, READ, u32x4, candidates) B(1, READ, u32, candidate_radii) B(2, READ, u32, lists)  \
    B(3, READ, u32x4, entries) B(4, BOTH, u32, statuses) B(5, WRITE, u32x2, samples)            \
    B(6, WRITE, u32, survivors) B(7, SHARED, u32, survivor_count) B(8, SHARED, u32, failure)
#define REACH_BINDINGS(B)                                                                    \
    B(0, READ, u32x4, candidates) B(1, READ, u32, candidate_radii) B(2, READ, u32, statuses)    \
    B(3, READ, u32x4, node_places) B(4, READ, u32x4, node_links) B(5, READ, u32, node_of)    \
    B(6, SHARED, u32, visitor_count) B(7, SHARED, u32, visitor_heads)                        \
    B(8, WRITE, u32x2, visitors) B(9, READ, u32, survivors) B(10, READ, u32, survivor_count) \
    B(11, SHARED, u32, failure)
#define ADMIT_WITH_FIELD_BINDINGS(B)                                                          \
    B(0, READ, u32x4, candidates) B(1, READ, u32, candidate_radii) B(2, SHARED, u32, statuses)  \
    B(3, READ, u32, visitor_heads) B(4, READ, u32x2, visitors) B(5, SHARED, u32, undecided)  \
    B(6, WRITE, u32x2, samples) B(7, SHARED, u32, failure)
#define ENLIST_BINDINGS(B)                                                                   \
    B(0, READ, u32, undecided) B(1, READ, u32x4, candidates)                                 \
    B(2, READ, u32, candidate_radii) B(3, READ, u32, statuses) B(4, READ, u32, visitor_heads)   \
    B(5, READ, u32x2, visitors) B(6, SHARED, u32, entry_count) B(7, WRITE, u32x4, entries)   \
    B(8, BOTH, u32, lists) B(9, SHARED, u32, failure)
#define SPLIT_BINDINGS(B)                                                                    \
    B(0, READ, u32, undecided) B(1, READ, u32, axes) B(2, READ, u32x2, radius_bounds)        \
    B(3, READ, u32, mask_bits) B(4, READ, u32x4, places) B(5, READ, u32, uneven)             \
    B(6, WRITE, u32x4, strips) B(7, WRITE, u32, strip_radii) B(8, SHARED, u32, failure)
#define CUT_PLACES_BINDINGS(B)                                                               \
    B(0, READ, u32, undecided) B(1, READ, u32x4, places) B(2, READ, u32x2, origins)          \
    B(3, READ, u32, lists) B(4, READ, u32x4, entries) B(5, WRITE, u32, counts)               \
    B(6, WRITE, u32x4, pieces) B(7, WRITE, u32x2, several) B(8, SHARED, u32, list_counts)    \
    B(9, SHARED, u32, failure)
#define CUT_HALVES_BINDINGS(B) CUT_PLACES_BINDINGS(B) B(10, WRITE, u32x4, more_pieces)
#define CUT_UNEVEN_BINDINGS(B)                                                               \
    B(0, READ, u32, undecided) B(1, READ, u32, uneven) B(2, READ, u32x2, origins)            \
    B(3, READ, u32x4, strips) B(4, READ, u32, strip_radii) B(5, READ, u32, lists)            \
    B(6, READ, u32x4, entries) B(7, WRITE, u32, counts) B(8, WRITE, u32x4, pieces)           \
    B(9, WRITE, u32x4, more_pieces) B(10, WRITE, u32x2, several)                             \
    B(11, SHARED, u32, list_counts) B(12, SHARED, u32, failure)
#define CUT_SEVERAL_BINDINGS(B)                                                              \
    B(0, READ, u32x4, places) B(1, READ, u32x2, origins) B(2, READ, u32x4, strips)           \
    B(3, READ, u32, strip_radii) B(4, READ, u32, lists) B(5, READ, u32x4, entries)           \
    B(6, WRITE, u32, counts) B(7, READ, u32x2, several) B(8, READ, u32, list_counts)         \
    B(9, SHARED, u32, failure)
#define KEEP_PLACES_BINDINGS(B)                                                              \
    B(0, READ, u32, undecided) B(1, READ, u32x4, places) B(2, READ, u32x2, origins)          \
    B(3, READ, u32x4, pieces) B(4, READ, u32, counts) B(5, READ, u32, sums)                  \
    B(6, WRITE, u32x4, new_places) B(7, WRITE, u32x2, new_origins) B(8, WRITE, u32, widths)  \
    B(9, WRITE, u32, free_lengths) B(10, WRITE, u32, new_uneven)                             \
    B(11, SHARED, u32, list_counts) B(12, SHARED, u32, failure)
#define KEEP_HALVES_BINDINGS(B) KEEP_PLACES_BINDINGS(B) B(13, READ, u32x4, more_pieces)
#define KEEP_UNEVEN_BINDINGS(B)                                                              \
    B(0, READ, u32, undecided) B(1, READ, u32, uneven) B(2, READ, u32x2, origins)            \
    B(3, READ, u32x4, strips) B(4, READ, u32, strip_radii) B(5, READ, u32x4, pieces)         \
    B(6, READ, u32x4, more_pieces) B(7, READ, u32, counts) B(8, READ, u32, sums)             \
    B(9, WRITE, u32x4, new_places) B(10, WRITE, u32x2, new_origins) B(11, WRITE, u32, widths) \
    B(12, WRITE, u32, free_lengths) B(13, WRITE, u32, new_uneven)                            \
    B(14, SHARED, u32, list_counts) B(15, SHARED, u32, failure)
#define KEEP_SEVERAL_BINDINGS(B)                                                             \
    B(0, READ, u32x4, places) B(1, READ, u32x2, origins) B(2, READ, u32x4, strips)           \
    B(3, READ, u32, strip_radii) B(4, READ, u32, lists) B(5, READ, u32x4, entries)           \
    B(6, READ, u32, counts) B(7, READ, u32, sums) B(8, WRITE, u32x4, new_places)             \
    B(9, WRITE, u32x2, new_origins) B(10, WRITE, u32, widths) B(11, WRITE, u32, free_lengths) \
    B(12, WRITE, u32, new_uneven) B(13, READ, u32x2, several)                                \
    B(14, SHARED, u32, list_counts) B(15, SHARED, u32, failure)
#define MEASURE_BINDINGS(B)                                                                  \
    B(0, READ, u32, axes) B(1, READ, u32x2, radius_bounds) B(2, READ, u32, mask_bits)        \
    B(3, READ, u32, new_uneven) B(4, READ, u32, list_counts) B(5, READ, u32x4, new_places)   \
    B(6, BOTH, u32x2, new_origins) B(7, READ, u32, undecided) B(8, SHARED, u32, failure)

// All buffers, of which a kernel has those that its bindings name.
#define LACUNA_BUFFERS(B)                                                                         \
    B(u32x4, draws) B(u32x4, located) B(u32, column_begins) B(u32, buckets) B(u32x4, candidates)  \
    B(u32, statuses) B(u32, undecided) B(u32x2, samples) B(u32, failure) B(u32, free_lengths)        \
    B(u32x2, spans) B(u32x2, new_spans) B(u32, span_counts) B(u32, overflow) B(u32, near_begins)  \
    B(u32, near_counts) B(u32x2, near) B(u32, grid_x) B(u32, grid_y) B(u32, box_x)                \
    B(u32, box_begin) B(u32, box_end) B(u32, new_x) B(u32, new_begin) B(u32, new_end)             \
    B(u32, counts) B(u32, sums) B(u32, total) B(u32, piece_begin) B(u32, piece_end)               \
    B(u32, bin_begins) B(u32, bits) B(u32, widest) B(u32, widest_rows) B(u32, column_of)        \
    B(u32, row_of) B(u32, row_begins) B(u32, pixel_radii) B(u32, pixel_reaches)                   \
    B(u32, candidate_radii) B(u32, todo) B(u32, left) B(u32, left_count) B(u32, axes)             \
    B(u32x2, radius_bounds) B(u32, mask_bits) B(u32x4, places) B(u32x2, origins)                  \
    B(u32x4, new_places) B(u32x2, new_origins) B(u32, widths) B(u32x4, pieces)                    \
    B(u32x4, more_pieces) B(u32x4, strips) B(u32, strip_radii) B(u32x2, several)                  \
    B(u32, uneven) B(u32, new_uneven) B(u32, list_counts) B(u32x4, node_places)                   \
    B(u32x4, node_links) B(u32, node_of) B(u32, visitor_count) B(u32, visitor_heads)              \
    B(u32x2, visitors) B(u32, lists) B(u32x4, entries)                                            \
    B(u32, entry_count) B(u32, survivors) B(u32, survivor_count)                                  \
    LACUNA_RELAX_BUFFERS(B)

// All kernels: name, arguments, bindings.
#define LACUNA_KERNELS(K)                                             \
    K(locate, SlabArguments, LOCATE_BINDINGS)                         \
    K(locate_in_boxes, DrawArguments, LOCATE_IN_BOXES_BINDINGS)       \
    K(locate_in_cells, SlabArguments, LOCATE_IN_CELLS_BINDINGS)       \
    K(sort_columns, ColumnArguments, SORT_COLUMNS_BINDINGS)           \
    K(look_up_radii, DrawArguments, LOOK_UP_RADII_BINDINGS)           \
    K(screen, DrawArguments, SCREEN_BINDINGS)                         \
    K(screen_on_lines, SlabArguments, SCREEN_ON_LINES_BINDINGS)       \
    K(screen_in_cells, DrawArguments, SCREEN_IN_CELLS_BINDINGS)       \
    K(admit, DrawArguments, ADMIT_BINDINGS)                           \
    K(admit_in_cells, DrawArguments, ADMIT_IN_CELLS_BINDINGS)         \
    K(insert, DrawArguments, INSERT_BINDINGS)                         \
    K(collect, ColumnArguments, COLLECT_BINDINGS)                       \
    K(subtract, SlabArguments, SUBTRACT_BINDINGS)                     \
    K(grow, SlabArguments, GROW_BINDINGS)                             \
    K(unfold, SlabArguments, UNFOLD_BINDINGS)                         \
    K(cut, StripArguments, CUT_BINDINGS)                              \
    K(keep, StripArguments, KEEP_BINDINGS)                            \
    K(scan, ScanArguments, SCAN_BINDINGS)                             \
    K(find_bin_begins, ColumnArguments, FIND_BIN_BEGINS_BINDINGS) \
    K(subtract_in_cells, DrawArguments, SUBTRACT_IN_CELLS_BINDINGS)   \
    K(locate_with_field, DrawArguments, LOCATE_WITH_FIELD_BINDINGS)     \
    K(screen_with_field, DrawArguments, SCREEN_WITH_FIELD_BINDINGS)     \
    K(reach, DrawArguments, REACH_BINDINGS)                           \
    K(admit_with_field, DrawArguments, ADMIT_WITH_FIELD_BINDINGS)       \
    K(enlist, DrawArguments, ENLIST_BINDINGS)                         \
    K(split, StripArguments, SPLIT_BINDINGS)                          \
    K(measure, StripArguments, MEASURE_BINDINGS)                      \
    K(cut_places, StripArguments, CUT_PLACES_BINDINGS)                \
    K(cut_halves, StripArguments, CUT_HALVES_BINDINGS)                \
    K(cut_uneven, StripArguments, CUT_UNEVEN_BINDINGS)                \
    K(cut_several, StripArguments, CUT_SEVERAL_BINDINGS)              \
    K(keep_places, StripArguments, KEEP_PLACES_BINDINGS)              \
    K(keep_halves, StripArguments, KEEP_HALVES_BINDINGS)              \
    K(keep_uneven, StripArguments, KEEP_UNEVEN_BINDINGS)              \
    K(keep_several, StripArguments, KEEP_SEVERAL_BINDINGS)            \
    LACUNA_RELAX_KERNELS(K)
// clang-format on

#endif

// What one element of a buffer is, where it has several words. The host's structs of the same names
// have the same members in the same order, unless a comment says otherwise.
//
// OpenCL C and GLSL read and write an element at once, with LOAD and STORE: in OpenCL C because it
// is aligned to its size; in GLSL as a vector, because drivers access a struct word by word, and
// GPU-assisted validation does not check such accesses.
#ifndef LACUNA_PORTABLE_ELEMENTS_H
#define LACUNA_PORTABLE_ELEMENTS_H
#include "types.h"

#if defined(__cplusplus) || defined(__OPENCL_C_VERSION__)
#if defined(__cplusplus)
#define LACUNA_ALIGNED(Name, bytes)
#else
#define LACUNA_ALIGNED(Name, bytes) typedef struct Name Name __attribute__((aligned(bytes)));
#endif
#define PAIR(Name, A, a, B, b) \
    struct Name {              \
        A a;                   \
        B b;                   \
    };                         \
    LACUNA_ALIGNED(Name, 8)
#define FOUR(Name, A, a, B, b, C, c, D, d) \
    struct Name {                          \
        A a;                               \
        B b;                               \
        C c;                               \
        D d;                               \
    };                                     \
    LACUNA_ALIGNED(Name, 16)

#else  // GLSL: each element has its struct, the struct of its words, and functions between them.
#define WordsOfu32 uint
#define LACUNA_FUNCTIONS_OF_PAIR(Name, A, a, B, b) \
    struct WordsOf##Name {                         \
        uvec2 words;                               \
    };                                             \
    Name Name##_of(const uvec2 words) {            \
        return Name(A(words.x), B(words.y));       \
    }                                              \
    uvec2 words_of(const Name from) {              \
        return uvec2(from.a, from.b);              \
    }
#define PAIR(Name, A, a, B, b) \
    struct Name {              \
        A a;                   \
        B b;                   \
    };                         \
    LACUNA_FUNCTIONS_OF_PAIR(Name, A, a, B, b)
#define LACUNA_FUNCTIONS_OF_FOUR(Name, A, a, B, b, C, c, D, d)       \
    struct WordsOf##Name {                                           \
        uvec4 words;                                                 \
    };                                                               \
    Name Name##_of(const uvec4 words) {                              \
        return Name(A(words.x), B(words.y), C(words.z), D(words.w)); \
    }                                                                \
    uvec4 words_of(const Name from) {                                \
        return uvec4(from.a, from.b, from.c, from.d);                \
    }
#define FOUR(Name, A, a, B, b, C, c, D, d) \
    struct Name {                          \
        A a;                               \
        B b;                               \
        C c;                               \
        D d;                               \
    };                                     \
    LACUNA_FUNCTIONS_OF_FOUR(Name, A, a, B, b, C, c, D, d)
#endif

LACUNA_BEGIN

// Rounds, as in rounds/round.h.
FOUR(Draw, u32, bin, u32, rank, u32, offset, u32, order)
FOUR(Candidate, u32, x, u32, y, u32, home, u32, order)
PAIR(Spot, u32, x, u32, y)

// A free span of a line, or a piece of a strip: the heights [begin, end).
PAIR(Span, u32, begin, u32, end)

LACUNA_FN Span span_of(u32 begin, u32 end) {
    Span span;
    span.begin = begin;
    span.end = end;
    return span;
}

// Mode exact: the positions [x, x + width) times [begin, end).
FOUR(Box, u32, x, u32, width, u32, begin, u32, end)

// With a radius field: a box's block of first boxes (plan/first_boxes.h), and the least radius
// under the box, with IS_EVEN if it is the only one (radius_field.h), or 0 until measure has looked
// it up.
PAIR(Origin, u32, block, u32, radius)

// Where a box on unlike pixels is cut when it is halved: between its halves, and across each.
FOUR(Borders, u32, x, u32, left_y, u32, right_y, u32, unused)
// The least radii of the strips between these borders, perhaps with IS_EVEN.
FOUR(StripRadii, u32, left_below, u32, left_above, u32, right_below, u32, right_above)
// The least and the greatest radius of a square of pixels: see radius_field.h.
PAIR(Radii, u32, least, u32, greatest)
// The ellipse of a pixel: see ellipse.h.
FOUR(Ellipse, u32, p, u32, q, u32, s, u32, shift)

// A node of the tree of blocks: FirstBoxes::Node of the host, without its box.
FOUR(Links, u32, greatest, u32, next, u32, first_block, u32, whole)
// A block's node in that tree, and the least radius under the block.
PAIR(BlockNode, u32, node, u32, least)
// A candidate that reaches a block, and the number of the block's next visitor.
PAIR(Visitor, u32, candidate, u32, next)
// A sample in the list of a block, and the number of the list's next entry.
FOUR(Neighbour, u32, x, u32, y, u32, radius, u32, next)

// Space: a part of a solid, of a triangle (u, v, the triangle's number), of a box (i, j, k).
// `shape` is the level, and SHAPE_FLIPPED if it is a flipped triangle: see space.h.
FOUR(Portion, u32, first, u32, second, u32, third, u32, shape)
// A corner of a triangle. The three corners follow each other; the first two have the low and the
// high word of the triangle's weight.
FOUR(Corner, i32, x, i32, y, i32, z, u32, weight)
// A sample in the list of its block, and the number of the list's next entry.
FOUR(Listed, i32, x, i32, y, i32, z, u32, next)

// Relax: the host's Site has its weight in one number.
FOUR(Site, u32, x, u32, y, u32, weight_low, u32, weight_high)
// A rectangle that contains the sites of a node of their tree, and the least of their weights.
FOUR(Bounds, u32, low_x, u32, low_y, u32, high_x, u32, high_y)
PAIR(Wide, u32, low, u32, high)
// A site that may win lattice points of a unit: its Lag (site_tree.h), and its order among ties.
FOUR(ShortLag, i32, at, i32, along_x, i32, along_y, u32, order)
// A sample that descends the Gaussian energy.
FOUR(Mover, u32, x, u32, y, i32, momentum_x, i32, momentum_y)

LACUNA_END

#endif

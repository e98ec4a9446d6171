// Parts of surfaces and volumes, which are drawn from and split, and distances in space. Positions
// are whole numbers; distances have the unit of the axes.
//
// A part of a triangle is (level, u, v): its corner is u and v steps along two of the triangle's
// sides, each cut into 2^31 steps, and its own sides are 2^(31 - level) steps long, backwards if it
// is flipped. A part of a box is (level, i, j, k): the box's sides are cut into 2^level lengths,
// and it has the i-th, j-th and k-th of them. So a position is rounded once, whatever the level.
#ifndef LACUNA_PORTABLE_SPACE_H
#define LACUNA_PORTABLE_SPACE_H
#include "elements.h"

LACUNA_BEGIN

struct Position {
    i32 x;
    i32 y;
    i32 z;
};
LACUNA_TYPEDEF(Position)

// A triangle of the mesh, or a box from `a` up to, not including, `b`.
struct Solid {
    Position a;
    Position b;
    Position c;
};
LACUNA_TYPEDEF(Solid)

#define SHAPE_LEVEL 255u
#define SHAPE_FLIPPED 256u
#define LAST_LEVEL_OF_TRIANGLES 31u

LACUNA_FN u64 squared_distance(Position a, Position b) {
    i64 x = to_i64(a.x) - to_i64(b.x);
    i64 y = to_i64(a.y) - to_i64(b.y);
    i64 z = to_i64(a.z) - to_i64(b.z);
    return to_u64(x * x) + to_u64(y * y) + to_u64(z * z);
}

LACUNA_FN Position moved(Position a, Position by) {
    Position position;
    position.x = a.x + by.x;
    position.y = a.y + by.y;
    position.z = a.z + by.z;
    return position;
}

// What the marginal multiplies: together the weight, of which the highest 32 bits count. Weights
// are below 2^63.
struct BinSize {
    u32 along;
    u32 across;
};
LACUNA_TYPEDEF(BinSize)

LACUNA_FN BinSize size_of(u64 weight) {
    u32 shift = 32u - leading_zeros(to_u32(weight >> 32));
    BinSize size;
    size.along = to_u32(weight >> shift);
    size.across = 1u << shift;
    return size;
}

// ------------------------------------------------------------------------------------ triangles

// Rounded to the nearest unit. At most 2^61, as u + v is at most 2^31 and sides at most 2^30.
LACUNA_FN i32 along_sides(i32 a, i32 b, i32 c, u32 u, u32 v) {
    i64 of_u = to_i64(u) * (to_i64(b) - to_i64(a));
    i64 of_v = to_i64(v) * (to_i64(c) - to_i64(a));
    return to_i32(to_u32(to_u64(to_i64(a) + ((of_u + of_v + to_i64(1073741824u)) >> 31))));
}

LACUNA_FN Position on_triangle(Solid triangle, u32 u, u32 v) {
    Position position;
    position.x = along_sides(triangle.a.x, triangle.b.x, triangle.c.x, u, v);
    position.y = along_sides(triangle.a.y, triangle.b.y, triangle.c.y, u, v);
    position.z = along_sides(triangle.a.z, triangle.b.z, triangle.c.z, u, v);
    return position;
}

// A side of a part, in steps; modulo 2^32, as it may be negative.
LACUNA_FN u32 side_in_steps(u32 shape) {
    u32 side = 1u << (31u - (shape & SHAPE_LEVEL));
    return (shape & SHAPE_FLIPPED) != 0u ? 0u - side : side;
}

// A part of the last level is its first corner.
LACUNA_FN bool is_corner(Portion part) {
    return (part.shape & SHAPE_LEVEL) == LAST_LEVEL_OF_TRIANGLES;
}

LACUNA_FN Position corner_of_triangle(Solid triangle, Portion part, u32 corner) {
    u32 side = is_corner(part) ? 0u : side_in_steps(part.shape);
    return on_triangle(triangle, part.first + (corner == 1u ? side : 0u),
                       part.second + (corner == 2u ? side : 0u));
}

// Part 0 to 3 of a part that is no corner: the three at its corners, then the flipped one.
LACUNA_FN Portion quarter(Portion part, u32 which) {
    Portion piece;
    u32 half_side = side_in_steps(part.shape + 1u);
    piece.first = part.first + ((which & 1u) != 0u ? half_side : 0u);
    piece.second = part.second + (which >= 2u ? half_side : 0u);
    piece.third = part.third;
    piece.shape = part.shape + 1u;
    if (which == 3u) piece.shape = piece.shape ^ SHAPE_FLIPPED;
    return piece;
}

// A random position (u, v) in a part, from 31 random bits each. What lies beyond the diagonal of
// the parallelogram is turned back into the triangle.
struct OnTriangle {
    u32 u;
    u32 v;
};
LACUNA_TYPEDEF(OnTriangle)

LACUNA_FN OnTriangle drawn_on_triangle(Portion part, u32 for_u, u32 for_v) {
    const u32 most = 2147483647u;
    u32 level = part.shape & SHAPE_LEVEL;
    bool is_beyond = for_u + for_v > most;
    u32 u = (is_beyond ? most - for_u : for_u) >> level;
    u32 v = (is_beyond ? most - for_v : for_v) >> level;
    bool is_flipped = (part.shape & SHAPE_FLIPPED) != 0u;
    OnTriangle drawn;
    drawn.u = is_flipped ? part.first - u : part.first + u;
    drawn.v = is_flipped ? part.second - v : part.second + v;
    return drawn;
}

LACUNA_FN u64 weight_of_triangle(u64 weight, Portion part) {
    u32 shift = 2u * (part.shape & SHAPE_LEVEL);
    u64 share = shift < 64u ? weight >> shift : 0u;
    return share == 0u ? 1u : share;
}

// ---------------------------------------------------------------------------------------- boxes

// Where part `index` of a side from `low` to `high` begins.
LACUNA_FN i32 cut_of_side(i32 low, i32 high, u32 index, u32 level) {
    i64 length = to_i64(high) - to_i64(low);
    return to_i32(to_u32(to_u64(to_i64(low) + ((length * to_i64(index)) >> level))));
}

LACUNA_FN Position low_corner(Solid box, Portion part) {
    Position position;
    position.x = cut_of_side(box.a.x, box.b.x, part.first, part.shape);
    position.y = cut_of_side(box.a.y, box.b.y, part.second, part.shape);
    position.z = cut_of_side(box.a.z, box.b.z, part.third, part.shape);
    return position;
}

LACUNA_FN Position high_corner(Solid box, Portion part) {
    Position position;
    position.x = cut_of_side(box.a.x, box.b.x, part.first + 1u, part.shape);
    position.y = cut_of_side(box.a.y, box.b.y, part.second + 1u, part.shape);
    position.z = cut_of_side(box.a.z, box.b.z, part.third + 1u, part.shape);
    return position;
}

// A part this small is its low corner, so that the splitting ends.
LACUNA_FN bool is_unit(Position low, Position high) {
    return high.x - low.x <= 1 && high.y - low.y <= 1 && high.z - low.z <= 1;
}

LACUNA_FN i32 shorter_half(i32 low, i32 middle, i32 high) {
    i32 below = middle - low;
    i32 above = high - middle;
    return below < above ? below : above;
}

// Whether a box, or one of the eight parts that meet at `middle`, is this small.
LACUNA_FN bool has_units(Position low, Position middle, Position high) {
    return shorter_half(low.x, middle.x, high.x) <= 1 &&
           shorter_half(low.y, middle.y, high.y) <= 1 && shorter_half(low.z, middle.z, high.z) <= 1;
}

// Part 0 to 7: bit 0 is along x, bit 1 along y, bit 2 along z.
LACUNA_FN Portion eighth(Portion part, u32 which) {
    Portion piece;
    piece.first = 2u * part.first + (which & 1u);
    piece.second = 2u * part.second + ((which >> 1) & 1u);
    piece.third = 2u * part.third + (which >> 2);
    piece.shape = part.shape + 1u;
    return piece;
}

// A bit for each of the eight parts that meet at `middle`, if it has volume.
LACUNA_FN u32 parts_with_volume(Position low, Position middle, Position high) {
    u32 parts = 255u;
    if (low.x == middle.x) parts = parts & 0xaau;
    if (low.y == middle.y) parts = parts & 0xccu;
    if (low.z == middle.z) parts = parts & 0xf0u;
    if (middle.x == high.x) parts = parts & 0x55u;
    if (middle.y == high.y) parts = parts & 0x33u;
    if (middle.z == high.z) parts = parts & 0x0fu;
    return parts;
}

LACUNA_FN u32 distance_to_farther_end(i32 at, i32 low, i32 high) {
    i64 below = to_i64(at) - to_i64(low);
    i64 above = to_i64(high) - to_i64(at);
    return to_u32(to_u64(below > above ? below : above));
}

// The square of the distance of a spot and the corner of a box that is farthest from it.
LACUNA_FN u64 squared_distance_to_farthest(Position from, Position low, Position high) {
    u64 x = distance_to_farther_end(from.x, low.x, high.x);
    u64 y = distance_to_farther_end(from.y, low.y, high.y);
    u64 z = distance_to_farther_end(from.z, low.z, high.z);
    return x * x + y * y + z * z;
}

LACUNA_FN i32 drawn_on_side(i32 low, i32 high, u32 bits) {
    u64 length = to_u64(to_i64(high) - to_i64(low));
    return low + to_i32(to_u32((length * bits) >> 32));
}

// The volume over 2^28, at least 1; 0 for a part without volume. Exact, in 64 bits: sides are at
// most 2^30.
LACUNA_FN u64 weight_of_box(Position low, Position high) {
    u64 x = to_u64(to_i64(high.x) - to_i64(low.x));
    u64 y = to_u64(to_i64(high.y) - to_i64(low.y));
    u64 z = to_u64(to_i64(high.z) - to_i64(low.z));
    u64 area = x * y;
    u64 share = (area >> 28) * z + (((area & 268435455u) * z) >> 28);
    return share == 0u && area != 0u && z != 0u ? 1u : share;
}

// -------------------------------------------------------------------------------------- volumes
//
// A volume is cut into cells, which are numbered along x, then y, then z.

LACUNA_FN Position place_of_cell(Position cells, u32 number) {
    u32 columns = to_u32(cells.x);
    u32 rows = to_u32(cells.y);
    Position place;
    place.x = to_i32(number % columns);
    place.y = to_i32(number / columns % rows);
    place.z = to_i32(number / columns / rows);
    return place;
}

LACUNA_FN i32 begin_of_cell(i32 side, i32 cells, i32 at) {
    return to_i32(to_u32(to_u64(to_i64(side) * to_i64(at) / to_i64(cells))));
}

LACUNA_FN Solid cell_at(Position sides, Position cells, Position place) {
    Solid box;
    box.a.x = begin_of_cell(sides.x, cells.x, place.x);
    box.a.y = begin_of_cell(sides.y, cells.y, place.y);
    box.a.z = begin_of_cell(sides.z, cells.z, place.z);
    box.b.x = begin_of_cell(sides.x, cells.x, place.x + 1);
    box.b.y = begin_of_cell(sides.y, cells.y, place.y + 1);
    box.b.z = begin_of_cell(sides.z, cells.z, place.z + 1);
    box.c = box.a;
    return box;
}

// One of the 27 cells around a cell and itself. Beyond the edge of a torus it is a cell at the
// other edge, whose samples are moved by `shift`.
struct NearCell {
    bool exists;
    u32 number;
    Position shift;
};
LACUNA_TYPEDEF(NearCell)

#define NEAR_CELLS 27u

LACUNA_FN i32 turns_beyond(i32 at, i32 cells) {
    return at < 0 ? -1 : (at >= cells ? 1 : 0);
}

LACUNA_FN NearCell near_cell(Position sides, Position cells, bool wraps, Position place,
                             u32 which) {
    i32 x = place.x + to_i32(which % 3u) - 1;
    i32 y = place.y + to_i32(which / 3u % 3u) - 1;
    i32 z = place.z + to_i32(which / 9u) - 1;
    i32 over_x = turns_beyond(x, cells.x);
    i32 over_y = turns_beyond(y, cells.y);
    i32 over_z = turns_beyond(z, cells.z);
    NearCell near;
    near.exists = wraps || (over_x == 0 && over_y == 0 && over_z == 0);
    near.shift.x = over_x * sides.x;
    near.shift.y = over_y * sides.y;
    near.shift.z = over_z * sides.z;
    x = x - over_x * cells.x;
    y = y - over_y * cells.y;
    z = z - over_z * cells.z;
    near.number = (to_u32(z) * to_u32(cells.y) + to_u32(y)) * to_u32(cells.x) + to_u32(x);
    return near;
}

LACUNA_END

#endif

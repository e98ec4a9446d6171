// The radius field on a device: the radius of each point, and where samples may lie
// (plan/radius_field.h).
#include "bodies/exact/pixels.h"
#include "portable/mask_tree.h"

#define NO_NODE 0xffffffffu

struct Under {
    u32 least;      // least radius except 0; 0 where no sample may lie
    u32 greatest;   // greatest radius, see HAS_ZEROS
    bool is_mixed;  // whether radii differ, or ellipses
    u32 allowed;    // what the mask allows
};
LACUNA_TYPEDEF(Under)

// The grids of the field and of the mask. A kernel reads them once: on lavapipe each read of a word
// costs as much as some steps of arithmetic.
struct Grids {
    PixelGrid field;
    PixelGrid mask;
};
LACUNA_TYPEDEF(Grids)

// The columns [first_column, last_column] of pixels, in the rows [first_row, last_row].
struct Pixels {
    u32 first_column;
    u32 last_column;
    u32 first_row;
    u32 last_row;
};
LACUNA_TYPEDEF(Pixels)

// The pixels that a box touches.
struct Touched {
    Pixels field;
    Pixels mask;
};
LACUNA_TYPEDEF(Touched)

// A level of a pyramid; its values are stored column by column.
struct Level {
    u32 shift;  // a value is for 2^shift x 2^shift pixels
    u32 first;
    u32 rows;
};
LACUNA_TYPEDEF(Level)

BODY bool has_mask(const Grids grids) {
    return grids.mask.columns.pixels != 0u;
}

BODY Pixels pixels_under(const PixelGrid grid, const Box box) {
    const Pixels pixels = {pixel_of(grid.columns, box.x),
                           pixel_of(grid.columns, box.x + box.width - 1u),
                           pixel_of(grid.rows, box.begin), pixel_of(grid.rows, box.end - 1u)};
    return pixels;
}

BODY Touched touched_by(const Grids grids, const Box box) {
    Touched touched;
    touched.field = pixels_under(grids.field, box);
    touched.mask = touched.field;  // not used without a mask
    if (has_mask(grids)) touched.mask = pixels_under(grids.mask, box);
    return touched;
}

// The lowest level of a pyramid where a rectangle of pixels touches at most 4 x 4 values.
BODY Level level_over(const PixelGrid grid, const Pixels pixels) {
    Level level = {0u, 0u, grid.rows.pixels};
    u32 columns = grid.columns.pixels;
    while ((pixels.last_column >> level.shift) - (pixels.first_column >> level.shift) >= 4u ||
           (pixels.last_row >> level.shift) - (pixels.first_row >> level.shift) >= 4u) {
        level.first += columns * level.rows;
        columns = (columns + 1u) / 2u;
        level.rows = (level.rows + 1u) / 2u;
        ++level.shift;
    }
    return level;
}

// The least and the greatest radius, see portable/radius_field.h.
BODY Radii radii_over(MEMORY const PixelGrid field, const Pixels pixels) {
    const Level level = level_over(field, pixels);
    Radii all = {0u, 0u};
    for (u32 i = pixels.first_column >> level.shift; i <= pixels.last_column >> level.shift; ++i) {
        for (u32 j = pixels.first_row >> level.shift; j <= pixels.last_row >> level.shift; ++j) {
            const Radii value = LOAD(Radii, radius_bounds, level.first + i * level.rows + j);
            all.least = least_of_radii(all.least, value.least);
            all.greatest = greatest_of_radii(all.greatest, value.greatest);
        }
    }
    return all;
}

// A node of the mask's tree (portable/mask_tree.h), and how wide its slots are: 2^shift pixels.
struct Node {
    u32 number;
    u32 shift;
};
LACUNA_TYPEDEF(Node)

// The merged value of the square of 2^level pixels that a pixel lies in. The square lies in the
// node, and is at most half as wide.
BODY u32 allowed_from(MEMORY const Node root, const u32 level, const u32 column, const u32 row) {
    Node node = root;
    u32 values = AT(mask_nodes, node.number * NODE_WORDS);
    u32 slot = slot_of(column, row, node.shift);
    while (node.shift > level && value_of_slot(values, slot) == ALLOWED_SOME) {
        node.number = AT(mask_nodes, node.number * NODE_WORDS + 1u) + rank_of_slot(values, slot);
        node.shift -= 2u;
        values = AT(mask_nodes, node.number * NODE_WORDS);
        slot = slot_of(column, row, node.shift);
    }
    return node.shift < level ? value_of_quadrant(values, slot) : value_of_slot(values, slot);
}

// The lowest node that contains a rectangle of pixels and is not lower than 2^level, or none: then
// `shift` is the value of the rectangle, and `number` is NO_NODE.
BODY Node node_over(MEMORY const PixelGrid mask, const u32 level, const Pixels pixels) {
    Node node = {0u, mask.columns.root};
    while (pixels.first_column >> node.shift == pixels.last_column >> node.shift &&
           pixels.first_row >> node.shift == pixels.last_row >> node.shift) {
        const u32 values = AT(mask_nodes, node.number * NODE_WORDS);
        const u32 slot = slot_of(pixels.first_column, pixels.first_row, node.shift);
        const u32 value = value_of_slot(values, slot);
        if (value != ALLOWED_SOME || node.shift <= level) {
            const Node none = {NO_NODE, value};
            return none;
        }
        node.number = AT(mask_nodes, node.number * NODE_WORDS + 1u) + rank_of_slot(values, slot);
        node.shift -= 2u;
    }
    return node;
}

BODY u32 allowed_over(MEMORY const PixelGrid mask, const Pixels pixels) {
    const Level level = level_over(mask, pixels);
    const Node node = node_over(ON mask, level.shift, pixels);
    if (node.number == NO_NODE) return node.shift;
    u32 seen = 0u;  // a bit for each value
    for (u32 i = pixels.first_column >> level.shift; i <= pixels.last_column >> level.shift; ++i) {
        for (u32 j = pixels.first_row >> level.shift; j <= pixels.last_row >> level.shift; ++j) {
            seen =
                seen | 1u << allowed_from(ON node, level.shift, i << level.shift, j << level.shift);
            if ((seen & (seen - 1u)) != 0u) return ALLOWED_SOME;
        }
    }
    if (seen == 1u << ALLOWED_NONE) return ALLOWED_NONE;
    return seen == 1u << ALLOWED_ALL ? ALLOWED_ALL : ALLOWED_SOME;
}

BODY Under under(MEMORY const Grids grids, const Touched touched) {
    const Radii radii = radii_over(ON grids.field, touched.field);
    const bool is_one = touched.field.first_column == touched.field.last_column &&
                        touched.field.first_row == touched.field.last_row;
    Under found = {radii.least, radii.greatest,
                   !is_one && are_radii_mixed(radii.least, radii.greatest), ALLOWED_ALL};
    if (has_mask(grids)) found.allowed = allowed_over(ON grids.mask, touched.mask);
    if (found.allowed == ALLOWED_NONE) found.least = 0u;
    return found;
}

// The least radius or, if samples may lie everywhere with one ellipse, the greatest with IS_EVEN;
// 0 where no sample may lie. A box that is not even is cut by circles of the least radius: with
// ellipses the greatest would cut off room.
BODY u32 radius_under(const Under all) {
    const bool is_even = all.least != 0u && !all.is_mixed && all.allowed == ALLOWED_ALL;
    return is_even ? all.greatest | IS_EVEN : all.least;
}

// 0 where no sample may lie.
BODY u32 radius_at(MEMORY const Grids grids, const u32 x, const u32 y) {
    const PixelGrid field = grids.field;
    const u32 pixel = pixel_of(field.columns, x) * field.rows.pixels + pixel_of(field.rows, y);
    const u32 radius = LOAD(Radii, radius_bounds, pixel).greatest & ~HAS_ZEROS;
    if (!has_mask(grids)) return radius;
    const PixelGrid mask = grids.mask;
    const Node root = {0u, mask.columns.root};
    const u32 allowed =
        allowed_from(ON root, 0u, pixel_of(mask.columns, x), pixel_of(mask.rows, y));
    return allowed == ALLOWED_NONE ? 0u : radius;
}

// The beginning of the middle one of the pixels first + 1 to last; 0 if first == last.
BODY u32 middle_border(const Axis axis, const u32 first, const u32 last) {
    if (first == last) return 0u;
    return begin_of(axis, first + (last - first + 1u) / 2u);
}

// The x at which to halve a box: at a border of pixels near its middle if the pixels are unlike,
// otherwise in its middle. 0: not to be cut. `all` describes what lies under the box.
BODY u32 cut_x(const Grids grids, const Box box, const Touched touched, const Under all) {
    const u32 copy = box.x & ~grids.field.columns.last;
    u32 cut = 0u;
    if (all.allowed == ALLOWED_SOME)
        cut =
            middle_border(grids.mask.columns, touched.mask.first_column, touched.mask.last_column);
    if (cut == 0u && all.is_mixed)
        cut = middle_border(grids.field.columns, touched.field.first_column,
                            touched.field.last_column);
    if (cut == 0u) return box.width > 1u ? box.x + box.width / 2u : 0u;
    return copy | cut;
}

BODY u32 cut_y(const Grids grids, const Touched touched, const Under all) {
    u32 cut = 0u;
    if (all.allowed == ALLOWED_SOME)
        cut = middle_border(grids.mask.rows, touched.mask.first_row, touched.mask.last_row);
    if (cut == 0u && all.is_mixed)
        cut = middle_border(grids.field.rows, touched.field.first_row, touched.field.last_row);
    return cut;
}

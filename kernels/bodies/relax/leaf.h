// Rectangles of the lattice: units and their leaves (portable/relax_kernels.h), and their positions
// relative to sites. Units with importance are listed by number, row by row; a launch serves a
// batch of the list.
#include "bodies/relax/site.h"
#include "portable/site_tree.h"

// A rectangle of lattice points: the lowest one, and the numbers of columns and rows.
struct Area {
    u32 left;
    u32 bottom;
    u32 width;
    u32 height;
};
LACUNA_TYPEDEF(Area)

BODY Area area_at(const LeafArguments a, const u32 left, const u32 bottom, const u32 side) {
    Area area;
    area.left = left;
    area.bottom = bottom;
    area.width = min(a.lattice.columns - left, side);
    area.height = min(a.lattice.rows - bottom, side);
    return area;
}

BODY Area unit_at(MEMORY const LeafArguments a, const u32 index) {
    const u32 number = AT(units, a.first_unit + index);
    const u32 side = a.side * LEAF_SIDE;
    return area_at(a, number % a.unit_columns * side, number / a.unit_columns * side, side);
}

BODY Area leaf_of(const LeafArguments a, const Area unit, const u32 i) {
    return area_at(a, unit.left + i % a.side * LEAF_SIDE, unit.bottom + i / a.side * LEAF_SIDE,
                   LEAF_SIDE);
}

// The number of a leaf among all leaves of the lattice.
BODY u32 number_of_leaf(const LeafArguments a, const Area leaf) {
    return leaf.bottom / LEAF_SIDE * a.leaf_columns + leaf.left / LEAF_SIDE;
}

// The area as seen from image (x, y) of the domain: 0 is a period below, 1 the domain itself, 2 a
// period above.
BODY Rect rect_of(const LeafArguments a, const Area area, const u32 x, const u32 y) {
    const i32 shift_x = to_i32(a.lattice.period_x - x * a.lattice.period_x);
    const i32 shift_y = to_i32(a.lattice.period_y - y * a.lattice.period_y);
    const i32 left = to_i32(lattice_place(area.left, a.lattice.step_x)) + shift_x;
    const i32 bottom = to_i32(lattice_place(area.bottom, a.lattice.step_y)) + shift_y;
    Rect box;
    box.left = left;
    box.bottom = bottom;
    box.right = left + to_i32((area.width - 1u) * a.lattice.step_x);
    box.top = bottom + to_i32((area.height - 1u) * a.lattice.step_y);
    return box;
}

// Which image of a site at `at` is the nearest to a position on an axis.
BODY u32 nearest_image(const u32 at, const u32 place, const u32 period) {
    if (period == 0u) return 1u;
    const u32 off = at > place ? at - place : place - at;
    return off <= period / 2u ? 1u : at > place ? 0u : 2u;
}

// 3 y + x for the image of a site that is nearest to the area's lowest lattice point.
BODY u32 image_near(const LeafArguments a, const Site site, const Area area) {
    const u32 x =
        nearest_image(site.x, lattice_place(area.left, a.lattice.step_x), a.lattice.period_x);
    const u32 y =
        nearest_image(site.y, lattice_place(area.bottom, a.lattice.step_y), a.lattice.period_y);
    return 3u * y + x;
}

// A site that has more power than this everywhere in the area cannot win there.
BODY u64 bound_by(const LeafArguments a, const Site site, const Area area) {
    const u32 image = image_near(a, site, area);
    return worst_power(to_i32(site.x), to_i32(site.y), weight_of(site),
                       rect_of(a, area, image % 3u, image / 3u));
}

// The solid that a bin is a part of: a triangle of the surface, or a cell of the volume.

// In kept_pieces[]: the bin is split. The bits below say which of its pieces stay; of a bin that is
// not split, bit 0 says that it stays.
#define IS_SPLIT 256u

BODY Position corner_at(const Corner corner) {
    const Position at = {corner.x, corner.y, corner.z};
    return at;
}

BODY Solid solid_of(MEMORY const Around around, const Portion part) {
    if (around.is_volume) return cell_at(around.sides, around.cells, around.place);
    const u32 first = 3u * part.third;
    const Solid triangle = {corner_at(LOAD(Corner, corners, first)),
                            corner_at(LOAD(Corner, corners, first + 1u)),
                            corner_at(LOAD(Corner, corners, first + 2u))};
    return triangle;
}

BODY BinSize size_of_part(MEMORY const Around around, const Solid solid, const Portion part) {
    if (around.is_volume)
        return size_of(weight_of_box(low_corner(solid, part), high_corner(solid, part)));
    const u64 low = LOAD(Corner, corners, 3u * part.third).weight;
    const u64 high = LOAD(Corner, corners, 3u * part.third + 1u).weight;
    return size_of(weight_of_triangle(low + (high << 32), part));
}

BODY Portion piece_of(const Around around, const Portion part, const u32 which) {
    if (around.is_volume) return eighth(part, which);
    return quarter(part, which);
}

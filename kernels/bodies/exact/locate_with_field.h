// The body of locate with a radius field: draws are bin, rank, offset, order; a candidate's line is
// the block that it lies in. Comes after radius_field.h.

BODY void serve_locate_with_field(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    for (u32 i = begin; i < end; ++i) {
        const u32x4 draw = AT(draws, i);
        const u32x4 box = AT(boxes, draw.x);
        const u32 x = box.x + draw.z;
        const u32 y = box.z + draw.y;
        AT(candidates, i) = U32X4(x, y, AT(origins, draw.x).x, draw.w);
        AT(candidate_radii, i) = radius_at(ON grids, x, y);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

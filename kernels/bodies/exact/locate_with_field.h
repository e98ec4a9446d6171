// The body of locate with a radius field: a candidate's home is the block of its box. Comes after
// radius_field.h.

BODY void serve_locate_with_field(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    for (u32 i = begin; i < end; ++i) {
        const Draw draw = LOAD(Draw, draws, i);
        const Box box = LOAD(Box, boxes, draw.bin);
        const u32 x = box.x + draw.offset;
        const u32 y = box.begin + draw.rank;
        const Candidate candidate = {x, y, LOAD(Origin, origins, draw.bin).block, draw.order};
        STORE(candidates, i, candidate);
        AT(candidate_radii, i) = radius_at(ON grids, x, y);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

// The body of locate where bins are boxes.

BODY void serve_locate_in_boxes(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const Draw draw = LOAD(Draw, draws, i);
        const Box box = LOAD(Box, boxes, draw.bin);
        const u32 x = box.x + draw.offset;
        const Candidate candidate = {x, box.begin + draw.rank, x / a.g.strip_width, draw.order};
        STORE(candidates, i, candidate);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
}

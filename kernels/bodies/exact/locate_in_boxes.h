// The body of locate where bins are boxes: draws are bin, rank, offset, order.

BODY void serve_locate_in_boxes(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const u32x4 draw = AT(draws, i);
        const u32x4 box = AT(boxes, draw.x);
        const u32 x = box.x + draw.z;
        AT(candidates, i) = U32X4(x, box.z + draw.y, x / a.g.strip_width, draw.w);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
}

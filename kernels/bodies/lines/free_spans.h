// The free parts of a line in lines and exact are its spans, from `slot` on.

BODY u32x2 piece_at(MEMORY const u32 slot, const u32 number) {
    return AT(spans, slot + number);
}

BODY u32 length_of(const u32x2 span) {
    return span.y - span.x;
}

BODY u32 height_of_rank(const u32x2 span, const u32 rank) {
    return span.x + rank;
}

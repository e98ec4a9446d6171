// Where pieces of strips go among the new places, for keep on a ground and keep_several.

// A strip's pieces go there and on.
BODY u32 place_of_first(MEMORY const StripArguments a, const u32 number) {
    return AT(counts, number) + AT(sums, number / a.block);
}

// The least radius under a piece is that of its strip, if the piece is all of it, or of its block,
// if that is even; else it is not known. What does not fit into the room is left out: the host sees
// the total, and asks again.
BODY void keep_piece(MEMORY const StripArguments a, const u32 number, const u32x2 piece,
                     const u32 to) {
    if (to >= a.room) return;
    const u32x4 strip = AT(places, number);
    const u32x2 origin = AT(origins, number);
    const bool is_whole = piece.x == strip.z && piece.y == strip.w;
    AT(new_places, to) = U32X4(strip.x, strip.y, piece.x, piece.y);
    AT(new_origins, to) = U32X2(origin.x, is_whole ? origin.y : AT(lists, origin.x).y);
}

// Where pieces of strips go among the new places, for keep_places and keep_several. Comes after
// strip.h.

// A place's pieces go there and on.
BODY u32 place_of_first(MEMORY const StripArguments a, const u32 number) {
    return AT(counts, number) + AT(sums, number >> a.block_bits);
}

// The least radius under a piece is that of its strip, if the piece is all of it or there is no
// other; else it is not known. Places under which there may be several are listed in new_uneven[].
// What does not fit into the room is left out: the host sees the total, and asks again.
BODY void keep_piece(MEMORY const StripArguments a, const Strip strip, const u32 block,
                     const u32x2 piece, const u32 to) {
    if (to >= a.room) return;
    const bool is_even = (strip.radius & IS_EVEN) != 0u;
    const bool is_whole = piece.x == strip.at.z && piece.y == strip.at.w;
    AT(new_places, to) = U32X4(strip.at.x, strip.at.y, piece.x, piece.y);
    AT(new_origins, to) = U32X2(block, is_even || is_whole ? strip.radius : 0u);
    if (!is_even) AT(new_uneven, ATOMIC_ADD(uneven_count, 0, 1u)) = to;
}

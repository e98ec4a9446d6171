// Where pieces of strips go among the new places, for keep_places, keep_halves, keep_uneven and
// keep_several. Comes after strip.h.

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
    const bool is_whole = piece.x == strip.at.z && piece.y == strip.at.w;
    const bool is_known = is_whole || is_even(strip.radius);
    AT(new_places, to) = U32X4(strip.at.x, strip.at.y, piece.x, piece.y);
    AT(new_origins, to) = U32X2(block, is_known ? strip.radius : 0u);
    AT(widths, to) = strip.at.y;
    AT(free_lengths, to) = piece.y - piece.x;
    if (!is_even(strip.radius)) AT(new_uneven, ATOMIC_ADD(list_counts, OF_NEW_UNEVEN, 1u)) = to;
}

// Keeps what is left of a strip (see Cut in touches.h), one piece or two, from number `first` on.
// Hands back the number after them. The loop goes on for those alone that have a second one.
BODY u32 keep_rest(MEMORY const StripArguments a, const Strip strip, const u32 block,
                   const u32x2 left, const u32x2 inside, const u32 first) {
    if (left.y == 0u) return first;
    u32x2 piece = U32X2(left.x, inside.y != 0u ? inside.x : left.y);
    u32 to = first;
    while (true) {
        keep_piece(ON a, strip, block, piece, to);
        ++to;
        if (piece.y == left.y) break;
        piece = U32X2(inside.y, left.y);
    }
    return to;
}

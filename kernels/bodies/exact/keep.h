// The body of keep: writes the pieces that cut has counted to the new boxes. Comes after pieces.h.
#include "bodies/common/sums.h"

// A piece that does not fit into the room is left out: the host sees the total, and launches again.
BODY void keep_piece(MEMORY const StripArguments a, const u32 from, const Strip strip,
                     const Span piece, const u32 to) {
    if (to >= a.room) return;
    const Box box = {strip.at.x, strip.at.width, piece.begin, piece.end};
    STORE(new_boxes, to, box);
    keep_origin(ON from, strip, box, to);
}

// Cuts a strip that has several pieces once more, and writes these from index `to` upwards. Returns
// the index after the last.
BODY u32 keep_several(MEMORY const StripArguments a, const u32 number, const HalvedBox box,
                      const Strip strip, const u32 to) {
    const Near near = near_of(ON a, number, box);
    const Pieces pieces = cut_strip(ON a, near, strip);
    u32 next = to;
    Span piece = span_of(pieces.low, pieces.low);
    while (piece.end < pieces.high) {
        piece = next_piece(ON a, near, strip, pieces, piece.end);
        if (piece.begin == piece.end) break;
        keep_piece(ON a, number, strip, piece, next);
        ++next;
    }
    return next;
}

// sum_before() is the index of the first piece of a box; its other pieces
// follow. Does nothing while a draw is undecided.
BODY void serve_keep(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes) << a.strip_bits;
    u32 number = NO_SAMPLE;
    u32 to = 0u;
    for (u32 index = item * a.chunk << a.strip_bits; index < end; ++index) {
        // A loop of its own: items in lockstep skip together, then work together.
        while (index < end && LOAD(Span, strip_pieces, index).end == 0u) ++index;
        if (index == end) break;
        if (index >> a.strip_bits != number) {
            number = index >> a.strip_bits;
            to = sum_before(ON number, a.block_bits);
        }
        const HalvedBox box = box_at(ON a, number);
        const Strip strip = strip_of(a, box, index & (1u << a.strip_bits) - 1u);
        const Span piece = LOAD(Span, strip_pieces, index);
        if (piece.end == NO_SAMPLE) {
            to = keep_several(ON a, number, box, strip, to);
        } else {
            keep_piece(ON a, number, strip, piece, to);
            ++to;
        }
    }
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

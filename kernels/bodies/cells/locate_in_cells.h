// The body of locate_in_cells: walks along the bits of a draw's line to the free lattice point of
// its rank.
#include "portable/bits.h"

// A draw is line, rank, offset, order. A line's draws ascend in rank.
BODY void serve_locate_in_cells(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    u32 line = NO_SAMPLE;
    u32 number = 0u;  // of a word of the line
    u32 passed = 0u;  // bits in the words below it
    u32 word = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32x4 draw = AT(draws, i);
        if (draw.x != line) {
            line = draw.x;
            number = 0u;
            passed = 0u;
            word = AT(bits, line * a.g.capacity);
        }
        while (draw.y - passed >= count_bits(word)) {
            passed += count_bits(word);
            ++number;
            word = AT(bits, line * a.g.capacity + number);
        }

        // A candidate is x, y, line, order.
        AT(located, i) = U32X4(line * a.g.strip_width + draw.z,
                               number * 32u + bit_of_rank(word, draw.y - passed), line, draw.w);
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

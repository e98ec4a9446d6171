// The body of locate in mode cells: the rank of each draw, walked to a y over the bits of its line.
#include "portable/bits.h"

// Serves a chunk of draws. A line has a.words words of bits, set where it is free.
BODY void serve_locate_in_cells(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    u32 line = NO_SAMPLE;
    u32 at = 0u;
    u32 passed = 0u;
    u32 word = 0u;
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const u32x4 draw = AT(draws, i);
        if (draw.x != line) {
            line = draw.x;
            at = 0u;
            passed = 0u;
            word = AT(bits, line * a.words);
        }

        // Walk the line's words until the rank falls into one.
        u32 free_bits = count_bits(word);
        while (draw.y - passed >= free_bits) {
            passed += free_bits;
            ++at;
            word = AT(bits, line * a.words + at);
            free_bits = count_bits(word);
        }

        // A candidate is x, y, line, order.
        AT(located, i) = U32X4(line, at * 32u + bit_of_rank(word, draw.y - passed), line, draw.w);
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

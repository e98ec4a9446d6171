// The body of locate_in_cells: walks along the bits of a draw's line to the free lattice point of
// its rank.
#include "portable/bits.h"

// A draw's bin is a line. A line's draws ascend in rank.
BODY void serve_locate_in_cells(MEMORY const SlabArguments a, const u32 item) {
    const u32 begin = a.first_draw + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.end_draw);
    u32 line = NO_SAMPLE;
    u32 number = 0u;  // of a word of the line
    u32 passed = 0u;  // bits in the words below it
    u32 word = 0u;
    for (u32 i = begin; i < end; ++i) {
        const Draw draw = LOAD(Draw, draws, i);
        if (draw.bin != line) {
            line = draw.bin;
            number = 0u;
            passed = 0u;
            word = AT(bits, line * a.g.capacity);
        }
        while (draw.rank - passed >= count_bits(word)) {
            passed += count_bits(word);
            ++number;
            word = AT(bits, line * a.g.capacity + number);
        }

        const Candidate candidate = {line * a.g.strip_width + draw.offset,
                                     number * 32u + bit_of_rank(word, draw.rank - passed), line,
                                     draw.order};
        STORE(located, i, candidate);
    }
    CHECK_TURNS(a.g.height, FAILED_LOCATE);
}

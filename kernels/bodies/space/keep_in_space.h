// The body of keep in space: writes the pieces that split has counted, and to results[] the lengths
// of all new bins, then their widths. Does nothing while a draw is undecided.
#include "bodies/common/sums.h"
#include "bodies/space/around.h"
#include "bodies/space/solid.h"

// If there are more pieces than room, the host sees the total, and launches again.
BODY void serve_keep_in_space(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 pieces = AT(report, TOTAL_WORD) - AT(report, SAMPLES_WORD);
    if (pieces > a.room) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const u32 kept = AT(kept_pieces, number);
        if ((kept & (IS_SPLIT - 1u)) == 0u) continue;
        const Portion part = LOAD(Portion, portions, number);
        const u32 block = AT(blocks, number);
        const Around around = blocks_around(ON block);
        const Solid solid = solid_of(ON around, part);
        u32 to = sum_before(ON number, a.block_bits);
        for (u32 i = 0u; i < 8u; ++i) {
            if ((kept >> i & 1u) == 0u) continue;
            Portion piece = part;
            if ((kept & IS_SPLIT) != 0u) piece = piece_of(around, part, i);
            const BinSize size = size_of_part(ON around, solid, piece);
            STORE(new_portions, to, piece);
            AT(new_blocks, to) = block;
            AT(results, to) = size.along;
            AT(results, pieces + to) = size.across;
            ++to;
        }
    }
    CHECK_TURNS(a.g.radius, FAILED_REFINE);
}

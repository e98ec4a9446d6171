// The body of locate in space: a draw becomes a random position in its bin.
#include "bodies/space/around.h"
#include "bodies/space/solid.h"

BODY Position drawn_position(MEMORY const u32 i, const Draw draw, const Around around,
                             const Portion part) {
    const Solid solid = solid_of(ON around, part);
    if (!around.is_volume) {
        const OnTriangle drawn = drawn_on_triangle(part, draw.rank >> 1, draw.offset >> 1);
        return on_triangle(solid, drawn.u, drawn.v);
    }
    const Position low = low_corner(solid, part);
    const Position high = high_corner(solid, part);
    const Position at = {drawn_on_side(low.x, high.x, draw.rank),
                         drawn_on_side(low.y, high.y, draw.offset),
                         drawn_on_side(low.z, high.z, AT(third_bits, i))};
    return at;
}

BODY void serve_locate_in_space(MEMORY const DrawArguments a, const u32 item) {
    const u32 begin = a.first + item * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 i = begin; i < end; ++i) {
        const Draw draw = LOAD(Draw, draws, i);
        const u32 block = AT(blocks, draw.bin);
        const Position at =
            drawn_position(ON i, draw, blocks_around(ON block), LOAD(Portion, portions, draw.bin));
        const Candidate candidate = {to_u32(at.x), to_u32(at.y), block, draw.order};
        STORE(candidates, i, candidate);
        AT(heights, i) = to_u32(at.z);
        AT(statuses, i) = STATUS_UNDECIDED;
    }
    CHECK_TURNS(a.g.radius, FAILED_LOCATE);
}

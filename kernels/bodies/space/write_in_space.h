// What results[] has of a sample in space: its coordinates or, on a surface, the number of its
// triangle and where it lies there (u, v).
#include "bodies/space/around.h"

#define SAMPLE_WORDS 3u

BODY void write_sample(MEMORY const u32 to, const u32 i, const Candidate admitted) {
    u32 first = admitted.x;
    u32 second = admitted.y;
    u32 third = AT(heights, i);
    if (AT(volume, VOLUME_SIDES) == 0u) {
        const Draw draw = LOAD(Draw, draws, i);
        const Portion part = LOAD(Portion, portions, draw.bin);
        const OnTriangle drawn = drawn_on_triangle(part, draw.rank >> 1, draw.offset >> 1);
        first = part.third;
        second = drawn.u;
        third = drawn.v;
    }
    AT(results, to) = first;
    AT(results, to + 1u) = second;
    AT(results, to + 2u) = third;
}

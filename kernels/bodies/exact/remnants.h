// What samples leave of a strip of a place with a radius field, for cut_places, cut_halves,
// cut_uneven, cut_several and keep_several (docs/design.md, section 4, "exact with a field").
#include "bodies/exact/strip.h"
#include "portable/chord.h"
#include "portable/distance.h"

// A chord covers the whole width of a strip: it is cut at the far edge.
BODY u32 cut_distance(const Geometry g, const u32x4 strip, const u32 x) {
    const u32 middle = strip.y / 2u;
    return axis_distance(x, strip.x + middle, g.period_x) + middle;
}

// A list goes from the latest entry to the first, and those that count have numbers from
// first_recent on.
BODY bool is_in_list(const StripArguments a, const u32 number) {
    return number != NO_SAMPLE && number >= a.first_recent;
}

// What the chords leave of a strip: [low, high), less those inside, if there are any. Most chords
// cover one of its ends.
struct Rest {
    u32 low;
    u32 high;
    u32 insides;   // how many chords lay inside when they were cut
    u32x2 inside;  // the last of them
};
LACUNA_TYPEDEF(Rest)

BODY Rest all_of(const Strip strip) {
    const Rest rest = {strip.at.z, strip.at.w, 0u, U32X2(0u, 0u)};
    return rest;
}

BODY Rest without_chord(const Rest whole, const u32 begin, const u32 end) {
    Rest rest = whole;
    if (begin >= end || end <= rest.low || begin >= rest.high) return rest;
    if (begin <= rest.low)
        rest.low = min(end, rest.high);
    else if (end >= rest.high)
        rest.high = begin;
    else {
        ++rest.insides;
        rest.inside = U32X2(begin, end);
    }
    return rest;
}

// A sample at distance dx covers no more than any point of the strip lets it cover.
BODY u32 sized_reach(const Strip strip, const u32 dx, const u32 sample_radius) {
    u64 limit = min(sample_radius, radius_of(strip));
    return chord_reach(dx, limit * limit);
}

BODY Rest without_sample(const StripArguments a, const Strip strip, const Rest whole, const u32 dx,
                         const u32 y, const u32 sample_radius) {
    const u32 windows = a.g.period_y != 0u ? 3u : 1u;
    const u32 reach = sized_reach(strip, dx, sample_radius);
    Rest rest = whole;
    for (u32 window = 0u; window < windows; ++window)
        rest = without_chord(rest, window_begin(window, y, reach, a.g.height),
                             window_end(window, y, reach, a.g.height));
    return rest;
}

// What samples leave of a place on a ground, for cut_on_ground, cut_several and
// keep_several (docs/design.md, section 4, "exact with a field").
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/distance.h"

// A place, or one of the parts that split made of it.
struct Strip {
    u32x4 at;
    u32 radius;  // the least under it
    u32 list;    // of its block
};
LACUNA_TYPEDEF(Strip)

BODY Strip strip_of(MEMORY const u32 number) {
    const u32x2 origin = AT(origins, number);
    Strip strip = {AT(places, number), origin.y, AT(lists, origin.x).x};
    return strip;
}

// The square of how far a sample reaches at most: no farther than any point of the strip lets it
// cover.
BODY u64 limit_of(const Strip strip, const u32x4 entry) {
    u64 limit = min(entry.z, strip.radius);
    return limit * limit;
}

// A chord covers the whole width of a strip: it is cut at the far edge.
BODY u32 cut_distance(const Geometry g, const Strip strip, const u32x4 entry) {
    const u32 middle = strip.at.y / 2u;
    return axis_distance(entry.x, strip.at.x + middle, g.period_x) + middle;
}

BODY bool is_in_list(const StripArguments a, const u32 number) {
    return number != NO_SAMPLE && number >= a.first_recent;
}

// What the chords leave of a strip: [low, high), less those inside, if there are any. Most chords
// cover one of its ends.
struct Rest {
    u32 low;
    u32 high;
    bool has_inside;
};
LACUNA_TYPEDEF(Rest)

BODY Rest without_chord(const Rest whole, const u32 begin, const u32 end) {
    Rest rest = whole;
    if (begin >= end || end <= rest.low || begin >= rest.high) return rest;
    if (begin <= rest.low)
        rest.low = min(end, rest.high);
    else if (end >= rest.high)
        rest.high = begin;
    else
        rest.has_inside = true;
    return rest;
}

BODY Rest without_sample(const StripArguments a, const Strip strip, const Rest whole,
                         const u32x4 entry) {
    const u32 windows = a.g.period_y != 0u ? 3u : 1u;
    const u32 reach = chord_reach(cut_distance(a.g, strip, entry), limit_of(strip, entry));
    Rest rest = whole;
    for (u32 window = 0u; window < windows; ++window)
        rest = without_chord(rest, window_begin(window, entry.y, reach, a.g.height),
                             window_end(window, entry.y, reach, a.g.height));
    return rest;
}

// By the samples of the list from number first_recent on: the latest stand first in it, and have
// the greatest numbers. Most are too far away, and one in three strips is covered by one sample:
// both show in squared distances. Of the others roots are taken, 32 entries at a time and in a loop
// of their own, so that items in lockstep take them together.
BODY Rest rest_of(MEMORY const StripArguments a, const Strip strip) {
    Rest rest = {strip.at.z, strip.at.w, false};
    u32 number = strip.list;
    while (is_in_list(a, number) && rest.low < rest.high) {
        u32 at = number;
        u32 touching = 0u;
        bool is_covered = false;
        for (u32 bit = 1u; bit != 0u && is_in_list(a, number); bit = bit << 1u) {
            const u32x4 entry = AT(entries, number);
            number = entry.w;
            const u64 limit = limit_of(strip, entry);
            const u32 dx = cut_distance(a.g, strip, entry);
            const u32 nearest = distance_to_stretch(entry.y, strip.at.z, strip.at.w, a.g.period_y);
            const u32 farthest =
                farthest_distance(to_i64(entry.y), to_i64(strip.at.z), to_i64(strip.at.w));
            touching = touching | (squared_length(dx, nearest) < limit ? bit : 0u);
            is_covered = is_covered || squared_length(dx, farthest) < limit;
        }
        if (is_covered) rest.high = rest.low;
        u32 passed = 0u;
        for (; touching != 0u && rest.low < rest.high; touching = touching & (touching - 1u)) {
            for (const u32 next = lowest_bit(touching); passed < next; ++passed)
                at = AT(entries, at).w;
            rest = without_sample(a, strip, rest, AT(entries, at));
        }
    }
    return rest;
}

// The lowest piece of the rest that begins at `from` or above: [x, y); empty if there is none.
BODY u32x2 next_piece(MEMORY const StripArguments a, const Strip strip, const Rest rest,
                      const u32 from) {
    const u32 windows = a.g.period_y != 0u ? 3u : 1u;
    u32 begin = from;
    while (begin < rest.high) {
        // Chords that cover `begin` move it up; else the lowest one above it ends the piece.
        u32 end = rest.high;
        bool has_moved = false;
        u32 number = rest.has_inside ? strip.list : NO_SAMPLE;
        while (is_in_list(a, number)) {
            const u32x4 entry = AT(entries, number);
            number = entry.w;
            const u32 reach = chord_reach(cut_distance(a.g, strip, entry), limit_of(strip, entry));
            for (u32 window = 0u; window < windows; ++window) {
                const u32 chord_begin = window_begin(window, entry.y, reach, a.g.height);
                const u32 chord_end = window_end(window, entry.y, reach, a.g.height);
                if (chord_begin >= chord_end || chord_end <= begin || chord_begin >= end) continue;
                has_moved = has_moved || chord_begin <= begin;
                begin = chord_begin <= begin ? chord_end : begin;
                end = chord_begin > begin ? chord_begin : end;
            }
        }
        if (!has_moved) return U32X2(begin, end);
    }
    return U32X2(rest.high, rest.high);
}

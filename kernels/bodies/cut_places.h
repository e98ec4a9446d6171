// The bodies of cut_places and cut_halves: cut places, or the strips of each where they are halved,
// by the samples listed for them. Come after remnants.h. Do nothing while admission is unsettled.

// Two strips of a place, one above the other, or one alone.
struct Pair {
    u32x4 at;
    u32 least;     // radius under them
    u32 greatest;  // of the least ones under either
};
LACUNA_TYPEDEF(Pair)

// A sample that takes something from a pair: how far away it is along x, as its chords are cut, and
// where along y.
struct Touch {
    u32 dx;
    u32 y;
    u32 radius;
};
LACUNA_TYPEDEF(Touch)

struct Touches {
    u32 count;
    Touch last;
    Touch second;  // from the last
    Touch third;
    bool is_covered;  // one of them covers all of the pair
};
LACUNA_TYPEDEF(Touches)

BODY Pair pair_of(const Strip low, const Strip high) {
    Pair both = {low.at, radius_of(low), radius_of(low)};
    if (is_empty(high)) return both;
    both.at.z = is_empty(low) ? high.at.z : low.at.z;
    both.at.w = high.at.w;
    both.least = least_of_radii(both.least, radius_of(high));
    both.greatest = max(both.greatest, radius_of(high));
    return both;
}

// In squared distances: only of samples that take something roots are taken, afterwards, for items
// in lockstep all take the time when one of them does.
BODY Touches with_sample(const StripArguments a, const Pair both, const Touches others,
                         const u32x4 entry) {
    u64 most = min(entry.z, both.greatest);
    u64 least = min(entry.z, both.least);
    most = most * most;
    least = least * least;
    const Touch touch = {cut_distance(a.g, both.at, entry.x), entry.y, entry.z};
    const u32 nearest = distance_to_stretch(entry.y, both.at.z, both.at.w, a.g.period_y);
    const u32 farthest = farthest_distance(to_i64(entry.y), to_i64(both.at.z), to_i64(both.at.w));
    Touches all = others;
    if (squared_length(touch.dx, nearest) < most) {
        all.third = others.second;
        all.second = others.last;
        all.last = touch;
        all.count = others.count + 1u;
        all.is_covered = others.is_covered || squared_length(touch.dx, farthest) < least;
    }
    return all;
}

BODY Rest rest_after(const StripArguments a, const Strip strip, const Touches touches) {
    Rest rest = {strip.at.z, touches.is_covered ? strip.at.z : strip.at.w, false};
    Touch touch = touches.last;
    for (u32 i = 0u; i < touches.count && i < 3u; ++i) {
        rest = without_sample(a, strip, rest, touch.dx, touch.y, touch.radius);
        touch = touches.third;
        if (i == 0u) touch = touches.second;
    }
    return rest;
}

// Cuts a place's strips. pieces[strip] is what is left of each, with an end of 0 where it is
// nothing; their number is handed back. Seldom more than three samples take something from a strip,
// or one cuts it inside: its place is left to cut_several, and then its first piece ends at
// NO_SAMPLE.
BODY u32 cut_place(MEMORY const StripArguments a, const bool is_halved, const u32 number) {
    const u32x4 place = AT(places, number);
    const u32x2 origin = AT(origins, number);
    const Pair left = pair_of(strip_of(ON is_halved, number, place, origin.y, 0u),
                              strip_of(ON is_halved, number, place, origin.y, 1u));
    const Pair right = pair_of(strip_of(ON is_halved, number, place, origin.y, 2u),
                               strip_of(ON is_halved, number, place, origin.y, 3u));
    const Touch nothing = {0u, 0u, 0u};
    Touches of_left = {0u, nothing, nothing, nothing, left.at.z == left.at.w};
    Touches of_right = {0u, nothing, nothing, nothing, right.at.z == right.at.w};
    u32 next = AT(lists, origin.x);
    while (is_in_list(a, next) && !(of_left.is_covered && of_right.is_covered)) {
        const u32x4 entry = AT(entries, next);
        next = entry.w;
        of_left = with_sample(a, left, of_left, entry);
        if (is_halved) of_right = with_sample(a, right, of_right, entry);
    }
    const u32 strips = strips_of_place(is_halved);
    bool may_be_several = false;
    u32 count = 0u;
    for (u32 k = 0u; k < strips; ++k) {
        const Strip strip = strip_of(ON is_halved, number, place, origin.y, k);
        Touches touches = of_left;
        if (k > 1u) touches = of_right;
        const Rest rest = rest_after(a, strip, touches);
        const bool is_left = rest.low < rest.high;
        AT(pieces, number * strips + k) = U32X2(rest.low, is_left ? rest.high : 0u);
        may_be_several = may_be_several || (is_left && (rest.has_inside || touches.count > 3u));
        count += is_left ? 1u : 0u;
    }
    if (may_be_several) {
        AT(several, ATOMIC_ADD(several_count, 0, 1u)) = number;
        AT(pieces, number * strips) = U32X2(0u, NO_SAMPLE);
    }
    return count;
}

BODY void cut_all(MEMORY const StripArguments a, const bool is_halved, const u32 item) {
    if (AT(undecided, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number)
        AT(counts, number) = cut_place(ON a, is_halved, number);
    CHECK_TURNS(a.g.height, FAILED_REFINE);
}

BODY void serve_cut_places(MEMORY const StripArguments a, const u32 item) {
    cut_all(ON a, false, item);
}

BODY void serve_cut_halves(MEMORY const StripArguments a, const u32 item) {
    cut_all(ON a, true, item);
}

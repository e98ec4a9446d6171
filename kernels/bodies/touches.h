// What the samples listed for a place leave of its strips, for cut_places, cut_halves and
// cut_uneven. Comes after remnants.h.

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

BODY Pair pair_of_one(const Strip strip) {
    const Pair pair = {strip.at, radius_of(strip), radius_of(strip)};
    return pair;
}

BODY Pair pair_of(const Strip low, const Strip high) {
    Pair both = pair_of_one(low);
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

// The samples that take something from the left half of a place and from the right, or from all of
// it and from nothing.
struct BothTouches {
    Touches left;
    Touches right;
};
LACUNA_TYPEDEF(BothTouches)

// Goes through the list once.
BODY BothTouches touches_of(MEMORY const StripArguments a, const Pair left, const bool has_right,
                            const Pair right, const u32 block) {
    const Touch nothing = {0u, 0u, 0u};
    Touches of_left = {0u, nothing, nothing, nothing, left.at.z == left.at.w};
    Touches of_right = {0u, nothing, nothing, nothing, !has_right || right.at.z == right.at.w};
    u32 next = AT(lists, block);
    while (is_in_list(a, next) && !(of_left.is_covered && of_right.is_covered)) {
        const u32x4 entry = AT(entries, next);
        next = entry.w;
        of_left = with_sample(a, left, of_left, entry);
        if (has_right) of_right = with_sample(a, right, of_right, entry);
    }
    const BothTouches both = {of_left, of_right};
    return both;
}

// The rest of a strip: [low, high), or 0 and 0 where nothing is left. Seldom more than three
// samples take something from a strip, or one cuts it inside: then it may be several pieces.
struct Cut {
    u32x2 piece;
    u32 count;
    bool may_be_several;
};
LACUNA_TYPEDEF(Cut)

BODY Cut cut_strip(const StripArguments a, const Strip strip, const Touches touches) {
    Rest rest = {strip.at.z, touches.is_covered ? strip.at.z : strip.at.w, false};
    Touch touch = touches.last;
    for (u32 i = 0u; i < touches.count && i < 3u; ++i) {
        rest = without_sample(a, strip, rest, touch.dx, touch.y, touch.radius);
        touch = touches.third;
        if (i == 0u) touch = touches.second;
    }
    const bool is_left = rest.low < rest.high;
    const Cut cut = {is_left ? U32X2(rest.low, rest.high) : U32X2(0u, 0u), is_left ? 1u : 0u,
                     is_left && (rest.has_inside || touches.count > 3u)};
    return cut;
}

// What is left of a place's strips, or of those of its left half. A place of which there may be
// several pieces is left to cut_several, and keeps none here.
BODY void put_pieces(MEMORY const u32 number, const u32x2 first, const u32x2 second,
                     const bool may_be_several) {
    if (may_be_several) AT(several, ATOMIC_ADD(several_count, 0, 1u)) = number;
    AT(pieces, number) =
        may_be_several ? U32X4(0u, 0u, 0u, 0u) : U32X4(first.x, first.y, second.x, second.y);
}

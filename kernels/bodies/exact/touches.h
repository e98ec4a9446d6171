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

// What is left of a strip: [x, y) but for [x, y) of what is inside; each is 0 and 0 where it is
// nothing. Seldom more than three samples take something from a strip, or two of them cut it
// inside: then there may be more pieces than that.
struct Cut {
    u32x2 piece;
    u32x2 inside;
    u32 count;
    bool may_be_several;
};
LACUNA_TYPEDEF(Cut)

BODY Cut cut_strip(const StripArguments a, const Strip strip, const Touches touches) {
    Rest rest = all_of(strip);
    if (touches.is_covered) rest.high = rest.low;
    Touch touch = touches.last;
    for (u32 i = 0u; i < touches.count && i < 3u; ++i) {
        rest = without_sample(a, strip, rest, touch.dx, touch.y, touch.radius);
        touch = touches.third;
        if (i == 0u) touch = touches.second;
    }
    const bool may_be_several = rest.insides > 1u || touches.count > 3u;
    // Later samples may have cut up to a chord that lay inside.
    if (rest.insides != 0u) {
        rest.insides = 0u;
        rest = without_chord(rest, rest.inside.x, rest.inside.y);
    }
    const bool is_left = rest.low < rest.high;
    const bool has_inside = is_left && rest.insides != 0u;
    const Cut cut = {is_left ? U32X2(rest.low, rest.high) : U32X2(0u, 0u),
                     has_inside ? rest.inside : U32X2(0u, 0u),
                     (is_left ? 1u : 0u) + (has_inside ? 1u : 0u), is_left && may_be_several};
    return cut;
}

// What is left of a place's strips: nothing here where there may be more pieces than Cuts can tell,
// for then the place is left to cut_several, which finds its strips as those of number `uneven`.
BODY void put_pieces(MEMORY const u32 number, const u32 uneven, const u32x4 left,
                     const bool may_be_several) {
    if (may_be_several)
        AT(several, ATOMIC_ADD(list_counts, OF_SEVERAL, 1u)) = U32X2(number, uneven);
    AT(pieces, number) = may_be_several ? U32X4(0u, 0u, 0u, 0u) : left;
}

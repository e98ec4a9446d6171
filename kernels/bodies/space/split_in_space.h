// The body of split in space: finds which pieces of each bin stay, and counts them. What one sample
// covers is dropped: a part is covered if its corners are, as balls are convex (docs/space.md).
#include "bodies/space/around.h"
#include "bodies/space/solid.h"

// The corners of a part, and whether it is split.
struct Splitting {
    u64 radius_squared;
    bool splits;
    bool has_units;  // a box may be one unit, or have pieces of one
    Position a;      // of a box its low corner
    Position b;      // of a box its high corner
    Position c;
    // The corners of the piece in the middle, each opposite to a, b or c.
    Position opposite_a;  // of a box its middle
    Position opposite_b;
    Position opposite_c;
};
LACUNA_TYPEDEF(Splitting)

BODY bool is_closer(const Splitting s, const Position one, const Position corner) {
    return squared_distance(one, corner) < s.radius_squared;
}

// The pieces of `kept` that the sample does not cover; 0 if it covers all of the part.
BODY u32 kept_of_triangle(const Splitting s, const Position one, const u32 kept) {
    if (is_closer(s, one, s.a) && is_closer(s, one, s.b) && is_closer(s, one, s.c)) return 0u;
    if (!s.splits) return kept;
    const bool at_a = is_closer(s, one, s.opposite_a);
    const bool at_b = is_closer(s, one, s.opposite_b);
    const bool at_c = is_closer(s, one, s.opposite_c);
    u32 covered = 0u;
    if (at_b && at_c && is_closer(s, one, s.a)) covered = covered | 1u;
    if (at_a && at_c && is_closer(s, one, s.b)) covered = covered | 2u;
    if (at_a && at_b && is_closer(s, one, s.c)) covered = covered | 4u;
    if (at_a && at_b && at_c) covered = covered | 8u;
    return kept & ~covered;
}

BODY u32 kept_of_box(const Splitting s, const Position one, const u32 kept) {
    // Pieces of one unit are their low corners. All others have the middle as a corner.
    const Position middle = s.opposite_a;
    if (!s.has_units && !is_closer(s, one, middle)) return kept;
    const Position end = is_unit(s.a, s.b) ? s.a : s.b;
    if (squared_distance_to_farthest(one, s.a, end) < s.radius_squared) return 0u;
    if (!s.splits) return kept;
    u32 covered = 0u;
    for (u32 i = 0u; i < 8u; ++i) {
        Position from;
        from.x = (i & 1u) != 0u ? middle.x : s.a.x;
        from.y = (i & 2u) != 0u ? middle.y : s.a.y;
        from.z = (i & 4u) != 0u ? middle.z : s.a.z;
        Position to;
        to.x = (i & 1u) != 0u ? s.b.x : middle.x;
        to.y = (i & 2u) != 0u ? s.b.y : middle.y;
        to.z = (i & 4u) != 0u ? s.b.z : middle.z;
        if (is_unit(from, to)) to = from;
        if (squared_distance_to_farthest(one, from, to) < s.radius_squared)
            covered = covered | 1u << i;
    }
    return kept & ~covered;
}

BODY Splitting splitting_of(const StripArguments a, const Around around, const Solid solid,
                            const Portion part, const BinSize size) {
    Splitting s;
    s.radius_squared = a.g.radius_squared;
    s.splits = a.strip_bits != 0u && to_u64(size.along) * size.across >= a.least_to_split;
    if (around.is_volume) {
        s.a = low_corner(solid, part);
        s.b = high_corner(solid, part);
        s.c = s.a;
        s.opposite_a = low_corner(solid, eighth(part, 7u));
        s.opposite_b = s.a;
        s.opposite_c = s.a;
        s.splits = s.splits && !is_unit(s.a, s.b);
        s.has_units = has_units(s.a, s.opposite_a, s.b);
    } else {
        s.has_units = false;
        s.splits = s.splits && !is_corner(part);
        s.a = corner_of_triangle(solid, part, 0u);
        s.b = corner_of_triangle(solid, part, 1u);
        s.c = corner_of_triangle(solid, part, 2u);
        Portion middle = part;
        if (s.splits) middle = quarter(part, 3u);
        s.opposite_a = corner_of_triangle(solid, middle, 0u);
        s.opposite_b = corner_of_triangle(solid, middle, 1u);
        s.opposite_c = corner_of_triangle(solid, middle, 2u);
    }
    return s;
}

BODY u32 kept_pieces_of(MEMORY const Around around, const Splitting s) {
    u32 kept = 1u;
    if (s.splits) kept = around.is_volume ? parts_with_volume(s.a, s.opposite_a, s.b) : 15u;
    for (u32 k = 0u; k < around.count && kept != 0u; ++k) {
        const NearCell near = block_around(ON around, k);
        u32 number = NO_SAMPLE;
        if (near.exists) number = AT(sample_heads, near.number);
        while (number != NO_SAMPLE && kept != 0u) {
            const Listed one = LOAD(Listed, listed, number);
            number = one.next;
            const Position at = listed_at(one, near);
            if (around.is_volume)
                kept = kept_of_box(s, at, kept);
            else
                kept = kept_of_triangle(s, at, kept);
        }
    }
    return kept;
}

// counts[bin] becomes the number of pieces that stay. Does nothing while a draw is undecided.
BODY void serve_split_in_space(MEMORY const StripArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 end = min((item + 1u) * a.chunk, a.boxes);
    for (u32 number = item * a.chunk; number < end; ++number) {
        const Portion part = LOAD(Portion, portions, number);
        const Around around = blocks_around(ON AT(blocks, number));
        const Solid solid = solid_of(ON around, part);
        const Splitting s =
            splitting_of(a, around, solid, part, size_of_part(ON around, solid, part));
        const u32 kept = kept_pieces_of(ON around, s);
        AT(kept_pieces, number) = kept | (s.splits ? IS_SPLIT : 0u);
        AT(counts, number) = count_bits(kept);
    }
    CHECK_TURNS(a.g.radius, FAILED_REFINE);
}

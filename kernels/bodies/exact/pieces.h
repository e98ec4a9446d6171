// Cuts a strip of a box by the samples near the box, and finds its pieces (docs/design.md, section
// 4). Comes after the neighbour index that finds the samples, grid.h or lists.h.

// All pieces lie in [low, high). `insides` counts the chords that cover neither end, which are few:
// if it is 0, [low, high) is the only piece.
struct Pieces {
    u32 low;
    u32 high;
    u32 insides;
};
LACUNA_TYPEDEF(Pieces)

BODY bool has_disks(const Geometry g) {
    return g.rule != RULE_OF_ELLIPSES;
}

// On a torus a chord continues at the other edge: see window_begin in chord.h.
BODY u32 windows_of(const Geometry g, const Strip strip) {
    const bool is_at_edge = strip.at.begin < strip.radius || g.height - strip.at.end < strip.radius;
    const bool has_classes = g.copy_bits != BITS_OF_ONE_COPY;  // they may reach farther
    return g.period_y != 0u && (is_at_edge || has_classes) ? 3u : 1u;
}

BODY Pieces without_chord(const Pieces all, const u32 begin, const u32 end) {
    Pieces pieces = all;
    if (begin >= end || end <= pieces.low || begin >= pieces.high) return pieces;
    if (begin <= pieces.low)
        pieces.low = min(end, pieces.high);
    else if (end >= pieces.high)
        pieces.high = begin;
    else
        ++pieces.insides;
    return pieces;
}

// Whether one sample's disk covers all of the strip, as in most halves. Needs no square root.
BODY bool is_covered_by_one(MEMORY const StripArguments a, const Near near, const Strip strip) {
    bool is_covered = false;
    Walk walk = walk_over(a, near);
    while (has_sample(a, near, walk) && !is_covered && has_disks(a.g)) {
        const Neighbour neighbour = sample_at(ON a, near, walk);
        walk = walk_past(near, walk, neighbour);
        const u32 dy =
            farthest_distance(to_i64(neighbour.y), to_i64(strip.at.begin), to_i64(strip.at.end));
        is_covered = squared_length(cut_distance(a.g, strip, x_of(a, neighbour, strip)), dy) <
                     limit_near(ON a, neighbour, strip);
    }
    return is_covered;
}

// The first sample of the walk, at `from` or later, that touches the strip. It compares squared
// distances, so that items in lockstep take square roots together, and only for such samples.
BODY Walk next_touching(MEMORY const StripArguments a, const Near near, const Strip strip,
                        const Walk from) {
    Walk walk = from;
    bool is_touching = false;
    while (has_sample(a, near, walk) && !is_touching) {
        const Neighbour neighbour = sample_at(ON a, near, walk);
        const u32 dx = cut_distance(a.g, strip, x_of(a, neighbour, strip));
        const u32 dy = distance_to_stretch(neighbour.y, strip.at.begin, strip.at.end, a.g.period_y);
        is_touching = squared_length(dx, dy) < limit_near(ON a, neighbour, strip);
        if (!is_touching) walk = walk_past(near, walk, neighbour);
    }
    return walk;
}

BODY Pieces cut_strip(MEMORY const StripArguments a, const Near near, const Strip strip) {
    Pieces pieces = {strip.at.begin, strip.at.end, 0u};
    if (strip.at.begin == strip.at.end) return pieces;
    if (is_covered_by_one(ON a, near, strip)) {
        pieces.high = pieces.low;
        return pieces;
    }
    const u32 windows = windows_of(a.g, strip);
    Walk walk = next_touching(ON a, near, strip, walk_over(a, near));
    while (has_sample(a, near, walk) && pieces.low < pieces.high) {
        const Neighbour neighbour = sample_at(ON a, near, walk);
        const Chord chord = chord_of(ON a, strip, neighbour);
        for (u32 window = 0u; window < windows; ++window)
            pieces = without_chord(pieces, begin_of_chord(a.g, chord, window),
                                   end_of_chord(a.g, chord, window));
        walk = next_touching(ON a, near, strip, walk_past(near, walk, neighbour));
    }
    return pieces;
}

// The lowest piece that begins at `from` or above; empty if there is none.
BODY Span next_piece(MEMORY const StripArguments a, const Near near, const Strip strip,
                     const Pieces pieces, const u32 from) {
    if (pieces.insides == 0u) return span_of(from, pieces.high);
    const u32 windows = windows_of(a.g, strip);
    u32 begin = from;
    while (begin < pieces.high) {
        // Chords that cover `begin` move it up; the lowest chord above it ends the piece.
        u32 end = pieces.high;
        bool has_moved = false;
        Walk walk = walk_over(a, near);
        while (has_sample(a, near, walk)) {
            const Neighbour neighbour = sample_at(ON a, near, walk);
            walk = walk_past(near, walk, neighbour);
            const Chord chord = chord_of(ON a, strip, neighbour);
            for (u32 window = 0u; window < windows; ++window) {
                const u32 chord_begin = begin_of_chord(a.g, chord, window);
                const u32 chord_end = end_of_chord(a.g, chord, window);
                if (chord_begin >= chord_end || chord_end <= begin || chord_begin >= end) continue;
                has_moved = has_moved || chord_begin <= begin;
                begin = chord_begin <= begin ? chord_end : begin;
                end = chord_begin > begin ? chord_begin : end;
            }
        }
        if (!has_moved) return span_of(begin, end);
    }
    return span_of(pieces.high, pieces.high);
}

// Sorting the chords that are cut from a box, and finding the pieces between them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plan/plan.h"

namespace lacuna::cpu {

// Moves the last of `count` chords to where it belongs among the others, which are sorted by their
// begin. An insertion, because the chords are few.
inline void sort_in_last(Span* chords, std::size_t count) {
    const Span chord = chords[count - 1];
    std::size_t to = count - 1;
    for (; to > 0 && chord.begin < chords[to - 1].begin; --to) chords[to] = chords[to - 1];
    chords[to] = chord;
}

// Calls keep(begin, end) for each piece of the strip that the sorted chords do not cover.
template <typename Chords, typename Keep>
void for_each_piece(Span strip, const Chords& chords, Keep keep) {
    std::uint32_t free_from = strip.begin;
    for (const Span chord : chords) {
        const std::uint32_t free_to = std::min(chord.begin, strip.end);
        if (free_from < free_to) keep(free_from, free_to);
        free_from = std::max(free_from, chord.end);
    }
    if (free_from < strip.end) keep(free_from, strip.end);
}

}  // namespace lacuna::cpu

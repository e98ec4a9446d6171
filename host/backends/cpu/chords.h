// Chords that are cut from a strip, sorted, and what they leave of it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plan/plan.h"

namespace lacuna::cpu {

// Puts the last of so many chords where it belongs among the others, which are sorted by where they
// begin: few, so by hand.
inline void sort_in_last(Span* chords, std::size_t count) {
    const Span chord = chords[count - 1];
    std::size_t to = count - 1;
    for (; to > 0 && chord.begin < chords[to - 1].begin; --to) chords[to] = chords[to - 1];
    chords[to] = chord;
}

// Calls keep(begin, end) for what sorted chords leave of [begin, end).
template <typename Chords, typename Keep>
void leave_of(Span strip, const Chords& chords, Keep keep) {
    std::uint32_t free_from = strip.begin;
    for (const Span chord : chords) {
        const std::uint32_t free_to = std::min(chord.begin, strip.end);
        if (free_from < free_to) keep(free_from, free_to);
        free_from = std::max(free_from, chord.end);
    }
    if (free_from < strip.end) keep(free_from, strip.end);
}

}  // namespace lacuna::cpu

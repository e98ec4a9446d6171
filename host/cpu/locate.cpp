// locate: the rank of each draw, walked to a y through its line's free spans.
#include <algorithm>

#include "cpu/state.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// Walks the line once for all its draws, which ascend in rank.
void walk(std::span<const Span> spans, std::span<Candidate> ascending) {
    const Span* span = spans.data();
    std::uint32_t passed = 0;
    for (Candidate& candidate : ascending) {
        std::uint32_t rank = candidate.y - passed;
        while (rank >= span->end - span->begin) {
            rank -= span->end - span->begin;
            passed += span->end - span->begin;
            ++span;
        }
        candidate.y = span->begin + rank;
    }
}

}  // namespace

void locate(State& state, std::span<const Draw> draws, std::uint32_t column) {
    const std::uint32_t begin = state.column_begins[column];
    const std::uint32_t end = state.column_begins[column + 1];

    for (std::uint32_t i = begin; i < end;) {
        // A line's draws are served together. Until the walk a candidate's y holds its rank.
        const std::uint32_t line = draws[i].line;
        std::uint32_t next = i;
        for (; next < end && draws[next].line == line; ++next)
            state.candidates[next] = {draws[next].x, draws[next].rank, line, draws[next].order};
        const std::span<Candidate> of_line(&state.candidates[i], next - i);
        std::sort(of_line.begin(), of_line.end(),
                  [](const Candidate& a, const Candidate& b) { return a.y < b.y; });
        walk(state.slot(line), of_line);
        i = next;
    }
    std::sort(state.candidates.begin() + begin, state.candidates.begin() + end,
              [](const Candidate& a, const Candidate& b) {
                  return a.y != b.y ? a.y < b.y : a.order < b.order;
              });
    std::fill(state.fates.begin() + begin, state.fates.begin() + end, FATE_UNDECIDED);
}

}  // namespace lacuna::cpu

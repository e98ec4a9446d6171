// locate: the rank of each draw, walked to a y through its place's free length.
#include <algorithm>
#include <span>

#include "backends/cpu/sort_column.h"
#include "backends/cpu/state.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// Draws [begin, end) of lines. A line is walked once for all its draws, which ascend in rank.
void locate_on_lines(State& state, std::span<const Draw> draws, std::uint32_t begin,
                     std::uint32_t end) {
    const Span* span = nullptr;
    std::uint32_t passed = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t line = draws[i].place;
        if (i == begin || line != draws[i - 1].place) {
            span = state.slot(line).data();
            passed = 0;
        }
        while (draws[i].rank - passed >= span->end - span->begin) {
            passed += span->end - span->begin;
            ++span;
        }
        state.candidates[i] = {line * state.plan.strip_width + draws[i].offset,
                               span->begin + (draws[i].rank - passed), line, draws[i].order};
    }
}

void locate_in_boxes(State& state, std::span<const Draw> draws, std::uint32_t column) {
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        const Box& box = state.boxes[column][draws[i].place - state.place_begins[column]];
        state.candidates[i] = {box.x + draws[i].offset, box.begin + draws[i].rank,
                               box.x / state.plan.strip_width, draws[i].order};
    }
}

}  // namespace

void locate(State& state, std::span<const Draw> draws, std::uint32_t column) {
    const std::uint32_t begin = state.column_begins[column];
    const std::uint32_t end = state.column_begins[column + 1];
    if (state.has_boxes())
        locate_in_boxes(state, draws, column);
    else
        locate_on_lines(state, draws, begin, end);
    sort_column(std::span(state.candidates).subspan(begin, end - begin), state.plan.height);
    std::fill(state.fates.begin() + begin, state.fates.begin() + end, FATE_UNDECIDED);
}

}  // namespace lacuna::cpu

// locate in mode cells: the rank of each draw, walked to a y over the bits of its line.
#include <bit>
#include <span>

#include "backends/cpu/cells_state.h"
#include "backends/cpu/sort_column.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

// The rank-th set bit of the word, which has more.
std::uint32_t bit_at_rank(std::uint64_t word, std::uint32_t rank) {
    for (; rank > 0; --rank) word &= word - 1;
    return static_cast<std::uint32_t>(std::countr_zero(word));
}

}  // namespace

void locate(CellsState& state, std::span<const Draw> draws, std::uint32_t column) {
    const std::uint32_t begin = state.column_begins[column];
    const std::uint32_t end = state.column_begins[column + 1];
    const std::uint64_t* word = nullptr;
    std::uint32_t passed = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        // A line is walked once for all its draws, which ascend in rank.
        const std::uint32_t line = draws[i].place;
        if (i == begin || line != draws[i - 1].place) {
            word = state.line(line).data();
            passed = 0;
        }
        auto free = static_cast<std::uint32_t>(std::popcount(*word));
        while (draws[i].rank - passed >= free) {
            passed += free;
            ++word;
            free = static_cast<std::uint32_t>(std::popcount(*word));
        }
        const auto y = static_cast<std::uint32_t>(word - state.line(line).data()) * 64 +
                       bit_at_rank(*word, draws[i].rank - passed);
        state.candidates[i] = {line, y, line, draws[i].order};
    }
    sort_column(std::span(state.candidates).subspan(begin, end - begin), state.plan.height);
    for (std::uint32_t i = begin; i < end; ++i) {
        const Candidate& candidate = state.candidates[i];
        state.candidate_radii[i] =
            state.radii.radii[state.radii.pixel_at(candidate.x, candidate.y)];
        state.fates[i] = FATE_UNDECIDED;
    }
}

}  // namespace lacuna::cpu

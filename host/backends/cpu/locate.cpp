// locate: finds the y of each draw by walking its rank along the bin's free length.
#include <algorithm>
#include <bit>
#include <span>

#include "backends/cpu/state.h"
#include "portable/bits.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// The pieces of a line's free length: its spans, or the words of its bits.
struct Spans {
    const SpanState& state;
    const Span* first_of(std::uint32_t line) const { return state.slot(line).data(); }
    std::uint32_t length(const Span* span) const { return span->end - span->begin; }
    std::uint32_t y_at(std::uint32_t, const Span* span, std::uint32_t rank) const {
        return span->begin + rank;
    }
};

struct Words {
    const BitState& state;
    const std::uint64_t* first_of(std::uint32_t line) const { return state.line(line).data(); }
    std::uint32_t length(const std::uint64_t* word) const {
        return static_cast<std::uint32_t>(std::popcount(*word));
    }
    std::uint32_t y_at(std::uint32_t line, const std::uint64_t* word, std::uint32_t rank) const {
        const auto y = static_cast<std::uint32_t>(word - first_of(line)) * 64;
        const auto low = static_cast<std::uint32_t>(*word);
        const std::uint32_t below = portable::count_bits(low);
        if (rank < below) return y + portable::bit_of_rank(low, rank);
        return y + 32 +
               portable::bit_of_rank(static_cast<std::uint32_t>(*word >> 32), rank - below);
    }
};

// A line is walked once for all its draws, which ascend in rank.
template <typename Pieces>
void locate_on_lines(State& state, std::span<const Draw> draws, std::uint32_t column,
                     Pieces pieces) {
    const std::uint32_t begin = state.column_begins[column];
    const std::uint32_t end = state.column_begins[column + 1];
    decltype(pieces.first_of(0)) piece = nullptr;
    std::uint32_t passed = 0;
    std::uint32_t length = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t line = draws[i].bin;
        if (i == begin || line != draws[i - 1].bin) {
            piece = pieces.first_of(line);
            length = pieces.length(piece);
            passed = 0;
        }
        while (draws[i].rank - passed >= length) {
            passed += length;
            length = pieces.length(++piece);
        }
        state.candidates[i] = {line * state.plan.strip_width + draws[i].offset,
                               pieces.y_at(line, piece, draws[i].rank - passed), line,
                               draws[i].order};
    }
}

void locate_in_boxes(SpanState& state, std::span<const Draw> draws, std::uint32_t column) {
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        const Box& box = state.boxes[column][draws[i].bin - state.bin_begins[column]];
        state.candidates[i] = {box.x + draws[i].offset, box.begin + draws[i].rank,
                               box.x / state.plan.strip_width, draws[i].order};
    }
}

void set_statuses(State& state, std::uint32_t column) {
    std::fill(state.statuses.begin() + state.column_begins[column],
              state.statuses.begin() + state.column_begins[column + 1], STATUS_UNDECIDED);
}

}  // namespace

void set_undecided(SpanState& state, std::uint32_t column) {
    if (!state.grid) state.sort_column(column);
    set_statuses(state, column);
}

void set_undecided(BitState& state, std::uint32_t column) {
    state.sort_column(column);
    set_statuses(state, column);
    state.find_radii(column);
}

void locate(SpanState& state, std::span<const Draw> draws, std::uint32_t column) {
    if (state.has_boxes)
        locate_in_boxes(state, draws, column);
    else
        locate_on_lines(state, draws, column, Spans{state});
    set_undecided(state, column);
    state.find_orders(column);
    if (state.grid) screen(state, column);
}

void locate(BitState& state, std::span<const Draw> draws, std::uint32_t column) {
    locate_on_lines(state, draws, column, Words{state});
    set_undecided(state, column);
    state.find_orders(column);
}

}  // namespace lacuna::cpu

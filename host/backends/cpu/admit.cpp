// admit in lines and cells: a candidate becomes a sample unless an earlier sample covers it.
//
// "Earlier" means by draw number, whatever the order of the work. Two small structs below say what
// covers a candidate in each mode, and how far away that may be. Exact is in darts.cpp.
#include <algorithm>
#include <atomic>
#include <span>

#include "backends/columns.h"
#include "backends/cpu/precedence.h"
#include "backends/cpu/reached.h"
#include "backends/cpu/state.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/metric.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// A mode defines the point at which candidate i counts, the columns to search and how far to search
// in them, and the squared distance that i must keep from candidate j.
struct InLines {
    const SpanState& state;
    portable::Stretch columns;

    InLines(const SpanState& the_state, std::uint32_t column)
        : state(the_state),
          columns(portable::stretch_around(column, 1, state.columns, state.plan.period_x)) {}
    // A candidate counts at its line's x: only the chord on that line matters.
    Sample at(std::uint32_t i) const {
        return {state.plan.centre_of_line(state.candidates[i].line), state.candidates[i].y};
    }
    template <typename Visit>
    bool any_column_near(std::uint32_t, Visit visit) const {
        for (std::uint32_t k = 0; k < columns.count; ++k)
            if (visit(portable::nth_of_stretch(columns, k, state.columns), state.plan.radius))
                return true;
        return false;
    }
    std::uint64_t limit_squared(std::uint32_t, std::uint32_t) const {
        return state.plan.radius_squared;
    }
};

struct InCells {
    const BitState& state;

    InCells(const BitState& the_state, std::uint32_t) : state(the_state) {}
    Sample at(std::uint32_t i) const { return {state.candidates[i].x, state.candidates[i].y}; }
    template <typename Visit>
    bool any_column_near(std::uint32_t i, Visit visit) const {
        return Reach(state, state.candidates[i], state.candidate_radii[i], state.widest_candidates)
            .any(visit);
    }
    std::uint64_t limit_squared(std::uint32_t i, std::uint32_t j) const {
        return portable::metric_squared(
            portable::twice_metric_radius(static_cast<std::uint32_t>(state.plan.cells().metric),
                                          state.candidate_radii[i], state.candidate_radii[j]));
    }
};

// The columns of one pass read each other's statuses while they change. That is safe: a status that
// is decided is final, and an undecided one only makes the reader wait.
std::uint32_t read(State& state, std::uint32_t i) {
    return std::atomic_ref(state.statuses[i]).load(std::memory_order_relaxed);
}

void decide(State& state, std::uint32_t i, std::uint32_t status) {
    std::atomic_ref(state.statuses[i]).store(status, std::memory_order_relaxed);
}

// Calls visit(index) for the column's candidates within `reach` of y until it returns true; true if
// it did.
template <typename Visit>
bool any_within(const State& state, std::uint32_t column, std::uint32_t y, std::uint32_t reach,
                Visit visit) {
    const std::uint32_t height = state.plan.height;
    const std::uint32_t end = state.column_begins[column + 1];
    const auto any_in = [&](std::uint32_t window) {
        const std::uint32_t low = portable::window_begin(window, y, reach, height);
        const std::uint32_t high = portable::window_end(window, y, reach, height);
        if (low >= high) return false;
        for (std::uint32_t i = state.first_from(column, low);
             i < end && state.candidates[i].y < high; ++i)
            if (visit(i)) return true;
        return false;
    };
    if (any_in(0)) return true;
    if (state.plan.period_y == 0 || (y >= reach && y + reach <= height)) return false;
    return any_in(1) || any_in(2);
}

// The status of candidate i, as far as it follows from the statuses near it.
template <typename Mode>
std::uint32_t status_of(State& state, const Mode& mode, std::uint32_t i) {
    const Plan& plan = state.plan;
    const Sample at = mode.at(i);
    bool waits = false;
    const auto covers = [&](std::uint32_t j) {
        const Candidate& other = state.candidates[j];
        if (!precedes(other, state.candidates[i]) ||
            !portable::are_closer(other.x, other.y, at.x, at.y, plan.period_x, plan.period_y,
                                  mode.limit_squared(i, j)))
            return false;
        const std::uint32_t status = read(state, j);
        waits = waits || status == STATUS_UNDECIDED;
        return status == STATUS_ADMITTED;
    };
    if (mode.any_column_near(i, [&](std::uint32_t column, std::uint32_t reach) {
            return any_within(state, column, at.y, reach, covers);
        }))
        return STATUS_REJECTED;
    return waits ? STATUS_UNDECIDED : STATUS_ADMITTED;
}

// About how many others candidate i is compared with: the candidates in the buckets that it looks
// into.
template <typename Mode>
std::uint64_t rivals_of(const State& state, const Mode& mode, std::uint32_t i) {
    const std::uint32_t height = state.plan.height;
    const std::uint32_t y = state.candidates[i].y;
    const std::uint32_t windows = state.plan.period_y == 0 ? 1 : 3;
    std::uint64_t rivals = 0;
    mode.any_column_near(i, [&](std::uint32_t column, std::uint32_t reach) {
        ++rivals;  // looking at a column costs about one comparison
        for (std::uint32_t window = 0; window < windows; ++window)
            rivals += state.count_between(column, portable::window_begin(window, y, reach, height),
                                          portable::window_end(window, y, reach, height));
        return false;
    });
    return rivals;
}

// One candidate in kSampled is counted, to estimate the comparisons of all.
constexpr std::uint32_t kSampled = 128;

template <typename Mode, typename ModeState>
std::uint32_t first_part_in(const ModeState& state) {
    const auto count = static_cast<std::uint32_t>(state.candidates.size());
    if (count <= kFewDraws) return count;
    std::uint64_t sampled = 0;
    std::uint64_t rivals = 0;
    for (std::uint32_t column = 0; column < state.columns; ++column) {
        const Mode mode(state, column);
        for (; sampled * kSampled < state.column_begins[column + 1]; ++sampled) {
            const auto i = static_cast<std::uint32_t>(sampled * kSampled);
            if (state.statuses[i] == STATUS_UNDECIDED) rivals += rivals_of(state, mode, i);
        }
    }
    if (rivals <= kMostRivals * sampled) return count;
    const std::uint64_t few = std::uint64_t{count} * kMostRivals * sampled / rivals;
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(few, kMostRivals));
}

template <typename Mode>
bool admit_in(State& state, const Mode& mode, std::uint32_t column) {
    bool are_decided = true;
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        if (read(state, i) != STATUS_UNDECIDED) continue;
        const std::uint32_t status = status_of(state, mode, i);
        if (status == STATUS_UNDECIDED)
            are_decided = false;
        else
            decide(state, i, status);
    }
    return are_decided;
}

}  // namespace

bool admit(SpanState& state, std::uint32_t column) {
    return admit_in(state, InLines(state, column), column);
}

bool admit(BitState& state, std::uint32_t column) {
    return admit_in(state, InCells(state, column), column);
}

std::uint32_t first_part(const SpanState& state) {
    return first_part_in<InLines>(state);
}

std::uint32_t first_part(const BitState& state) {
    return first_part_in<InCells>(state);
}

bool is_covered(const SpanState& state, const Candidate& candidate) {
    const std::span<const Span> spans =
        state.slot(candidate.line).first(state.span_counts[candidate.line]);
    const auto above = std::partition_point(
        spans.begin(), spans.end(), [&](const Span& span) { return span.end <= candidate.y; });
    return above == spans.end() || above->begin > candidate.y;
}

bool is_covered(const BitState& state, const Candidate& candidate) {
    return (state.line(candidate.x)[candidate.y / 64] >> candidate.y % 64 & 1) == 0;
}

}  // namespace lacuna::cpu

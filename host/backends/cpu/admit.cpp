// admit: a candidate becomes a sample unless an earlier sample covers it.
//
// "Earlier" is by the order of the draws, whatever the order of the work. What covers a candidate,
// and how far away, is the mode's: three small structs, below.
#include <algorithm>
#include <atomic>
#include <span>

#include "backends/cpu/precedence.h"
#include "backends/cpu/state.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/metric.h"

namespace lacuna::cpu {
namespace {

// A mode says where candidate i counts as being, how far to look around it, in which columns, and
// the square of the distance that it must keep from candidate j.
struct InExact {
    const SpanState& state;
    portable::Stretch columns;

    InExact(const SpanState& the_state, std::uint32_t column)
        : state(the_state),
          columns(portable::stretch_around(column, 1, state.columns, state.plan.period_x)) {}
    Sample place(std::uint32_t i) const { return {state.candidates[i].x, state.candidates[i].y}; }
    std::uint32_t reach(std::uint32_t) const { return state.plan.radius; }
    portable::Stretch columns_near(std::uint32_t) const { return columns; }
    std::uint64_t limit_squared(std::uint32_t, std::uint32_t) const {
        return state.plan.radius_squared;
    }
};

// On a line, what counts is the chord on that line.
struct InLines : InExact {
    using InExact::InExact;
    Sample place(std::uint32_t i) const {
        return {state.plan.centre_of_line(state.candidates[i].line), state.candidates[i].y};
    }
};

struct InCells {
    const BitState& state;

    InCells(const BitState& the_state, std::uint32_t) : state(the_state) {}
    Sample place(std::uint32_t i) const { return {state.candidates[i].x, state.candidates[i].y}; }
    std::uint32_t reach(std::uint32_t i) const { return state.reach_of(state.candidates[i]); }
    portable::Stretch columns_near(std::uint32_t i) const {
        const Plan& plan = state.plan;
        return portable::columns_of_stretch(
            portable::stretch_around(state.candidates[i].x, reach(i), plan.lines, plan.period_x),
            plan.lines, state.columns);
    }
    std::uint64_t limit_squared(std::uint32_t i, std::uint32_t j) const {
        return portable::metric_squared(
            portable::twice_metric_radius(static_cast<std::uint32_t>(state.plan.metric),
                                          state.candidate_radii[i], state.candidate_radii[j]));
    }
};

// Columns of one pass read each other's fates while they are decided. Whatever they see, a fate
// once decided is the right one.
std::uint32_t read(State& state, std::uint32_t i) {
    return std::atomic_ref(state.fates[i]).load(std::memory_order_relaxed);
}

void decide(State& state, std::uint32_t i, std::uint32_t fate) {
    std::atomic_ref(state.fates[i]).store(fate, std::memory_order_relaxed);
}

// Calls visit(index) for the column's candidates within `reach` of y, until it returns true; true
// if it did.
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

// What becomes of candidate i, as far as the fates of those near it are known.
template <typename Mode>
std::uint32_t fate_of(State& state, const Mode& mode, std::uint32_t i) {
    const Plan& plan = state.plan;
    const Sample place = mode.place(i);
    const std::uint32_t reach = mode.reach(i);
    bool waits = false;
    const auto covers = [&](std::uint32_t j) {
        const Candidate& other = state.candidates[j];
        if (!precedes(other, state.candidates[i]) ||
            !portable::conflicts(other.x, other.y, place.x, place.y, plan.period_x, plan.period_y,
                                 mode.limit_squared(i, j)))
            return false;
        const std::uint32_t fate = read(state, j);
        waits = waits || fate == FATE_UNDECIDED;
        return fate == FATE_ADMITTED;
    };
    const portable::Stretch near = mode.columns_near(i);
    for (std::uint32_t k = 0; k < near.count; ++k)
        if (any_within(state, portable::nth_of_stretch(near, k, state.columns), place.y, reach,
                       covers))
            return FATE_REJECTED;
    return waits ? FATE_UNDECIDED : FATE_ADMITTED;
}

template <typename Mode>
bool admit_in(State& state, const Mode& mode, std::uint32_t column) {
    bool settled = true;
    for (std::uint32_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        if (read(state, i) != FATE_UNDECIDED) continue;
        const std::uint32_t fate = fate_of(state, mode, i);
        if (fate == FATE_UNDECIDED)
            settled = false;
        else
            decide(state, i, fate);
    }
    return settled;
}

}  // namespace

bool admit(SpanState& state, std::uint32_t column) {
    if (state.plan.is_exact()) return admit_in(state, InExact(state, column), column);
    return admit_in(state, InLines(state, column), column);
}

bool admit(BitState& state, std::uint32_t column) {
    return admit_in(state, InCells(state, column), column);
}

void screen(SpanState& state, std::uint32_t column) {
    constexpr std::size_t kAhead = 6;  // what memory needs; 4 to 10 are alike
    const std::span<const Candidate> candidates = state.candidates_of(column);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& later = candidates[std::min(k + kAhead, candidates.size() - 1)];
        state.grid->fetch_near(later.x, later.y);
        const std::size_t i = state.column_begins[column] + k;
        if (state.fates[i] == FATE_UNDECIDED &&
            state.grid->is_covered(candidates[k].x, candidates[k].y))
            state.fates[i] = FATE_COVERED;
    }
}

}  // namespace lacuna::cpu

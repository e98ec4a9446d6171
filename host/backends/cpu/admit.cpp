// admit: a candidate becomes a sample unless an earlier sample covers it.
//
// "Earlier" is by the order of the draws, whatever the order of the work.
#include <algorithm>
#include <atomic>

#include "backends/cpu/precedence.h"
#include "backends/cpu/state.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/window.h"

namespace lacuna::cpu {
namespace {

// Columns of one pass read each other's fates while they are decided. Whatever they see, a fate
// once decided is the right one.
std::uint32_t read(State& state, std::size_t i) {
    return std::atomic_ref(state.fates[i]).load(std::memory_order_relaxed);
}

void decide(State& state, std::size_t i, std::uint32_t fate) {
    std::atomic_ref(state.fates[i]).store(fate, std::memory_order_relaxed);
}

// The candidates of one column within a radius in y, of one y after another in ascending order.
class Reach {
public:
    Reach(State& state, std::uint32_t column)
        : plan_(state.plan),
          begin_(state.column_begins[column]),
          candidates_(state.candidates_of(column)) {}

    // Calls visit(index) for each until it returns true; true if it did.
    template <typename Visit>
    bool any(std::uint32_t y, Visit visit) {
        const std::uint32_t low = portable::window_low(0, y, plan_.radius, plan_.height);
        while (hint_ < candidates_.size() && candidates_[hint_].y < low) ++hint_;
        const std::uint32_t high = portable::window_high(0, y, plan_.radius, plan_.height);
        if (any_from(hint_, high, visit)) return true;
        const bool is_at_edge = y < plan_.radius || high >= plan_.height;
        return plan_.period_y != 0 && is_at_edge && (any_in(1, y, visit) || any_in(2, y, visit));
    }

private:
    template <typename Visit>
    bool any_in(std::uint32_t window, std::uint32_t y, Visit visit) {
        const std::uint32_t low = portable::window_low(window, y, plan_.radius, plan_.height);
        const std::uint32_t high = portable::window_high(window, y, plan_.radius, plan_.height);
        if (low > high) return false;
        const auto first = std::lower_bound(
            candidates_.begin(), candidates_.end(), low,
            [](const Candidate& candidate, std::uint32_t at) { return candidate.y < at; });
        return any_from(static_cast<std::size_t>(first - candidates_.begin()), high, visit);
    }

    template <typename Visit>
    bool any_from(std::size_t first, std::uint32_t high, Visit visit) {
        for (std::size_t i = first; i < candidates_.size() && candidates_[i].y <= high; ++i)
            if (visit(begin_ + i)) return true;
        return false;
    }

    const Plan& plan_;
    std::size_t begin_;
    std::span<const Candidate> candidates_;
    std::size_t hint_ = 0;  // the first candidate not below the reach of the last y
};

}  // namespace

void screen(State& state, std::uint32_t column) {
    constexpr std::size_t kAhead = 6;  // what memory needs; 4 to 10 are alike
    const std::span<const Candidate> candidates = state.candidates_of(column);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& later = candidates[std::min(k + kAhead, candidates.size() - 1)];
        state.grid->fetch_near(later.x, later.y);
        const Candidate& candidate = candidates[k];
        const std::size_t i = state.column_begins[column] + k;
        if (state.fates[i] == FATE_UNDECIDED && state.grid->is_covered(candidate.x, candidate.y))
            state.fates[i] = FATE_COVERED;
    }
}

bool admit(State& state, std::uint32_t column) {
    const Plan& plan = state.plan;
    const std::uint32_t first = portable::first_neighbour(column, state.columns, plan.period_x);
    const std::uint32_t count = portable::neighbour_count(column, state.columns, plan.period_x);
    std::vector<Reach> neighbours;
    for (std::uint32_t i = 0; i < count; ++i)
        neighbours.emplace_back(state, (first + i) % state.columns);

    bool settled = true;
    for (std::size_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        if (read(state, i) != FATE_UNDECIDED) continue;
        const Candidate& candidate = state.candidates[i];
        // On a line, what counts is the chord on that line.
        const std::uint32_t x = plan.is_exact() ? candidate.x : plan.centre_of_line(candidate.line);
        bool waits = false;
        const auto covers = [&](std::size_t j) {
            const Candidate& other = state.candidates[j];
            if (!precedes(other, candidate) ||
                !portable::conflicts(other.x, other.y, x, candidate.y, plan.period_x, plan.period_y,
                                     plan.radius_squared))
                return false;
            const std::uint32_t fate = read(state, j);
            waits = waits || fate == FATE_UNDECIDED;
            return fate == FATE_ADMITTED;
        };
        const bool covered = std::any_of(neighbours.begin(), neighbours.end(), [&](Reach& reach) {
            return reach.any(candidate.y, covers);
        });
        if (covered)
            decide(state, i, FATE_REJECTED);
        else if (waits)
            settled = false;
        else
            decide(state, i, FATE_ADMITTED);
    }
    return settled;
}

}  // namespace lacuna::cpu

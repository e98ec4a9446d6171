// admit in mode cells: a candidate becomes a sample unless an earlier sample of the round is closer
// than the metric of their radii allows. See admit.cpp for the order of the work.
#include <algorithm>
#include <atomic>

#include "backends/cpu/cells_state.h"
#include "backends/cpu/precedence.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/metric.h"
#include "portable/window.h"

namespace lacuna::cpu {
namespace {

std::uint32_t read(CellsState& state, std::size_t i) {
    return std::atomic_ref(state.fates[i]).load(std::memory_order_relaxed);
}

class Decision {
public:
    Decision(CellsState& state, std::size_t index)
        : state_(state), index_(index), candidate_(state.candidates[index]) {}

    std::uint32_t fate() {
        // Look at all earlier candidates within reach.
        const std::uint32_t reach = state_.reach_of(candidate_);
        const std::uint32_t windows = state_.plan.period_y != 0 ? 3 : 1;
        state_.for_each_column_near(candidate_.x, reach, [&](std::uint32_t column) {
            for (std::uint32_t window = 0; window < windows && !covered_; ++window)
                look(column, portable::window_low(window, candidate_.y, reach, state_.plan.height),
                     portable::window_high(window, candidate_.y, reach, state_.plan.height));
        });
        if (covered_) return FATE_REJECTED;
        return waits_ ? FATE_UNDECIDED : FATE_ADMITTED;
    }

private:
    void look(std::uint32_t column, std::uint32_t low, std::uint32_t high) {
        const std::span<const Candidate> others = state_.candidates_of(column);
        const auto first =
            std::lower_bound(others.begin(), others.end(), low,
                             [](const Candidate& other, std::uint32_t at) { return other.y < at; });
        for (auto other = first; other != others.end() && other->y <= high && !covered_; ++other) {
            const std::size_t i =
                state_.column_begins[column] + static_cast<std::size_t>(other - others.begin());
            if (!precedes(*other, candidate_) || !conflict(i)) continue;
            const std::uint32_t fate = read(state_, i);
            covered_ = fate == FATE_ADMITTED;
            waits_ = waits_ || fate == FATE_UNDECIDED;
        }
    }

    bool conflict(std::size_t i) const {
        const Plan& plan = state_.plan;
        const std::uint32_t twice = portable::twice_metric_radius(
            static_cast<std::uint32_t>(plan.metric), state_.candidate_radii[index_],
            state_.candidate_radii[i]);
        const Candidate& other = state_.candidates[i];
        return portable::conflicts(other.x, other.y, candidate_.x, candidate_.y, plan.period_x,
                                   plan.period_y, portable::metric_squared(twice));
    }

    CellsState& state_;
    std::size_t index_;
    const Candidate& candidate_;
    bool covered_ = false;
    bool waits_ = false;
};

}  // namespace

bool admit(CellsState& state, std::uint32_t column) {
    bool settled = true;
    for (std::size_t i = state.column_begins[column]; i < state.column_begins[column + 1]; ++i) {
        if (read(state, i) != FATE_UNDECIDED) continue;
        const std::uint32_t fate = Decision(state, i).fate();
        std::atomic_ref(state.fates[i]).store(fate, std::memory_order_relaxed);
        settled = settled && fate != FATE_UNDECIDED;
    }
    return settled;
}

}  // namespace lacuna::cpu

// The cpu backend of mode cells: shares the columns out over threads.
#include "backends/cpu/cells_backend.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/cpu/cells_state.h"
#include "backends/cpu/workers.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

class CellsBackend : public Backend {
public:
    CellsBackend(const Plan& plan, std::uint32_t threads) : state_(plan), workers_(threads) {}

    std::string device() const override { return workers_.name(); }

    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        if (!is_set_) {
            const std::size_t amount = state_.plan.lines * state_.words;
            for_columns(amount, [&](std::uint32_t column) { set_free(state_, column); });
            is_set_ = true;
        }
        state_.candidates.resize(draws.size());
        state_.candidate_radii.resize(draws.size());
        state_.fates.resize(draws.size());
        find_column_begins(state_.first_lines, draws, state_.column_begins);
        for_columns(draws.size(),
                    [&](std::uint32_t column) { cpu::locate(state_, draws, column); });
    }

    void admit() override {
        while (!workers_.all_columns(
            state_.columns, state_.candidates.size(),
            [&](std::uint32_t column) { return cpu::admit(state_, column); })) {
        }
    }

    void subtract() override {
        find_near(state_);
        for_columns(state_.near.size(),
                    [&](std::uint32_t column) { cpu::subtract(state_, column); });
    }

    void refine(bool) override { throw std::logic_error("mode cells has nothing to refine"); }

    Round finish_round() override {
        by_order_.assign(state_.candidates.size(), kNone);
        for (std::uint32_t i = 0; i < by_order_.size(); ++i)
            if (state_.fates[i] == FATE_ADMITTED) by_order_[state_.candidates[i].order] = i;
        samples_.clear();
        for (const std::uint32_t i : by_order_)
            if (i != kNone) samples_.push_back({state_.candidates[i].x, state_.candidates[i].y});
        return {samples_, by_order_.size(), state_.free_lengths, 1};
    }

    Snapshot snapshot() override { return state_.snapshot(); }
    void restore(const Snapshot& snapshot) override {
        state_.restore(snapshot);
        is_set_ = true;
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    template <typename Work>
    void for_columns(std::size_t amount, Work work) {
        workers_.for_columns(state_.columns, amount, work);
    }

    CellsState state_;
    Workers workers_;
    bool is_set_ = false;  // the bits are set at the first round
    std::vector<std::uint32_t> by_order_;
    std::vector<Sample> samples_;
};

}  // namespace

std::unique_ptr<Backend> make_cells_backend(const Plan& plan, std::uint32_t threads) {
    return std::make_unique<CellsBackend>(plan, threads);
}

}  // namespace lacuna::cpu

// The cpu backend: shares the columns out over threads (oneTBB).
#include "backends/cpu/make_backend.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "backends/columns.h"
#include "backends/cpu/cells_backend.h"
#include "backends/cpu/state.h"
#include "backends/cpu/workers.h"
#include "portable/column.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

class CpuBackend : public Backend {
public:
    CpuBackend(const Plan& plan, std::uint32_t threads) : state_(plan), workers_(threads) {}

    std::string device() const override { return workers_.name(); }

    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        if (state_.grid && !is_grid_clear_) clear_grid();
        state_.candidates.resize(draws.size());
        state_.fates.resize(draws.size());
        find_column_begins(state_.place_begins, draws, state_.column_begins);
        for_columns(draws.size(),
                    [&](std::uint32_t column) { cpu::locate(state_, draws, column); });
    }

    void admit() override {
        const std::size_t draws = state_.candidates.size();
        if (state_.plan.is_exact())
            for_columns(draws, [&](std::uint32_t column) { cpu::screen(state_, column); });
        while (
            !all_columns(draws, [&](std::uint32_t column) { return cpu::admit(state_, column); })) {
        }
    }

    void subtract() override {
        insert();
        while (!all_columns(state_.candidates.size(),
                            [&](std::uint32_t column) { return cpu::subtract(state_, column); }))
            state_.grow();
    }

    void refine(bool halve) override {
        insert();
        const std::uint32_t width = state_.place_width() >> (halve ? 1 : 0);
        const std::size_t places = state_.place_begins.back();
        for_columns(places, [&](std::uint32_t column) { cpu::refine(state_, column, width); });
        state_.box_width = width;
        state_.spans.reset();
        state_.span_counts = {};
        measure_boxes();
    }

    Round finish_round() override {
        by_order_.assign(state_.candidates.size(), kNone);
        std::uint64_t survivors = 0;
        for (std::uint32_t i = 0; i < by_order_.size(); ++i) {
            survivors += state_.fates[i] != FATE_COVERED;
            if (state_.fates[i] == FATE_ADMITTED) by_order_[state_.candidates[i].order] = i;
        }
        samples_.clear();
        for (const std::uint32_t i : by_order_)
            if (i != kNone) samples_.push_back({state_.candidates[i].x, state_.candidates[i].y});
        return {samples_, survivors, state_.free_lengths, state_.place_width()};
    }

    Snapshot snapshot() override { return state_.snapshot(); }
    void restore(const Snapshot& snapshot) override {
        state_.restore(snapshot);
        is_grid_clear_ = true;
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    void clear_grid() {
        const std::uint64_t cells = state_.grid->columns();
        const auto share = [&](std::uint64_t column) {
            return static_cast<std::uint32_t>(column * cells / state_.columns);
        };
        for_columns(cells * state_.plan.grid_rows, [&](std::uint32_t column) {
            state_.grid->clear(share(column), share(column + std::uint64_t{1}));
        });
        is_grid_clear_ = true;
    }

    void insert() {
        if (!state_.plan.is_exact()) return;
        for_columns(state_.candidates.size(),
                    [&](std::uint32_t column) { cpu::insert(state_, column); });
    }

    // Where each column's boxes begin among all, and their lengths.
    void measure_boxes() {
        for (std::uint32_t i = 0; i < state_.columns; ++i)
            state_.place_begins[i + 1] =
                state_.place_begins[i] + static_cast<std::uint32_t>(state_.boxes[i].size());
        state_.free_lengths.resize(state_.place_begins.back());
        for_columns(state_.place_begins.back(), [&](std::uint32_t column) {
            std::transform(state_.boxes[column].begin(), state_.boxes[column].end(),
                           state_.free_lengths.begin() + state_.place_begins[column],
                           [](const Box& box) { return box.end - box.begin; });
        });
    }

    template <typename Work>
    void for_columns(std::size_t amount, Work work) {
        workers_.for_columns(state_.columns, amount, work);
    }
    template <typename Work>
    bool all_columns(std::size_t amount, Work work) {
        return workers_.all_columns(state_.columns, amount, work);
    }

    State state_;
    Workers workers_;
    bool is_grid_clear_ = false;           // they are cleared at the first round
    std::vector<std::uint32_t> by_order_;  // the sample of each draw, or kNone
    std::vector<Sample> samples_;
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    if (plan.is_cells()) return make_cells_backend(plan, placement.threads);
    return std::make_unique<CpuBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu

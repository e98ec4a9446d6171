// The verbs of the cpu backend as all modes do them: threads serve columns of lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/crowd.h"
#include "backends/cpu/state.h"
#include "base/workers.h"
#include "portable/status.h"

namespace lacuna::cpu {

// A mode adds admit, subtract and refine (make_backend.cpp).
template <typename ModeState>
class RoundBackend : public Backend {
public:
    RoundBackend(const Plan& plan, std::uint32_t threads) : state_(plan), workers_(threads) {}

    std::string device() const override { return workers_.name(); }
    Workers& workers() override { return workers_; }
    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        if (stage_ == Stage::none)
            for_columns(state_.plan.lines, [&](std::uint32_t i) { cpu::set_free(state_, i); });
        state_.begin_round(draws);
        for_columns(draws.size(), [&](std::uint32_t i) { cpu::locate(state_, draws, i); });
        state_.end_locate();
        stage_ = Stage::located;
    }

    Round finish_round() override {
        std::uint64_t survivors = 0;
        samples_.resize(state_.candidates.size());
        Sample* next = samples_.data();
        for (const std::uint32_t i : state_.by_order) {
            const Candidate& candidate = state_.candidates[i];
            survivors += static_cast<std::uint64_t>(stage_ == Stage::located ||
                                                    state_.statuses[i] != STATUS_COVERED);
            *next = {candidate.x, candidate.y};
            next += state_.statuses[i] == STATUS_ADMITTED;
        }
        samples_.resize(static_cast<std::size_t>(next - samples_.data()));
        if (state_.plan.tells_orders) find_orders();
        return {samples_,          survivors, state_.free_lengths, state_.bin_width,
                state_.bin_widths, orders_,   state_.bin_begins,   state_.sheet_ends};
    }
    std::vector<Candidate> located() override { return state_.candidates; }

    Snapshot snapshot() override { return state_.snapshot(stage_); }
    void restore(const Snapshot& snapshot) override {
        state_.restore(snapshot);
        stage_ = Stage::restored;
    }

protected:
    // Admits all draws at once or, if they crowd (crowd.h), part by part. cut() cuts the samples of
    // a part from the bins, and is_covered then finds the draws that they cover.
    template <typename Cut>
    void admit_by_passes(Cut cut) {
        const auto count = static_cast<std::uint32_t>(state_.candidates.size());
        std::uint32_t end = cpu::first_part(state_);
        stage_ = end == count ? Stage::admitted : Stage::cut;
        if (end == count) return decide_all();
        Crowd<ModeState> crowd(state_);
        for (std::uint32_t begin = 0; begin < count;
             begin = end, end += std::min(end, count - end)) {
            admit_part(crowd, {begin, end});
            cut();
        }
        crowd.give_back(state_);
    }

    // Calls work(column) for all columns; `amount` is the number of items in all columns together.
    template <typename Work>
    void for_columns(std::size_t amount, Work work) {
        workers_.for_columns(state_.columns, amount, work);
    }
    // The same for the round's candidates. Returns whether work returned true for all columns.
    template <typename Work>
    bool all_columns(Work work) {
        return workers_.all_columns(state_.columns, state_.candidates.size(), work);
    }

    // The same for slabs of columns.
    template <typename Work>
    void for_slabs(std::uint32_t slabs, std::size_t amount, Work work) {
        workers_.for_columns(slabs, amount, work);
    }
    // The number of slabs. A single thread uses slabs as well, for the cache's sake.
    std::uint32_t slabs() const {
        return std::clamp(state_.columns / kColumnsOfSlab, 1u, kMostSlabs);
    }

    // Throws Cancelled if the run is to stop.
    void poll() const { workers_.poll(); }

    ModeState state_;
    Stage stage_ = Stage::none;

private:
    // Columns of a slab. In narrower slabs too many draws are put off (darts.h); the cells of wider
    // ones do not stay in a core's cache. 64 was the fastest at 8 million points.
    static constexpr std::uint32_t kColumnsOfSlab = 64;
    static constexpr std::uint32_t kMostSlabs = 1024;

    // Lists the orders of the samples' draws.
    void find_orders() {
        orders_.clear();
        for (std::uint32_t order = 0; order < state_.by_order.size(); ++order)
            if (state_.statuses[state_.by_order[order]] == STATUS_ADMITTED)
                orders_.push_back(order);
    }

    void decide_all() {
        while (!all_columns([&](std::uint32_t i) { return cpu::admit(state_, i); })) {
        }
    }

    void admit_part(Crowd<ModeState>& crowd, Part part) {
        const std::size_t count = part.end;
        for_columns(count, [&](std::uint32_t i) { crowd.screen(state_, i, part); });
        crowd.make_room(state_);
        for_columns(count, [&](std::uint32_t i) { crowd.move_in(state_, i, part); });
        state_.end_locate();
        decide_all();
        for_columns(count, [&](std::uint32_t i) { crowd.move_out(state_, i); });
    }

    Workers workers_;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> orders_;  // with plan.tells_orders
};

}  // namespace lacuna::cpu

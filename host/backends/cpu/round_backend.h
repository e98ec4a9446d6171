// The verbs of the cpu backend as all modes do them: columns of lines, shared out over threads.
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
#include "backends/cpu/workers.h"
#include "portable/fate.h"

namespace lacuna::cpu {

// What a mode adds are subtract, refine and take_out (make_backend.cpp).
template <typename ModeState>
class RoundBackend : public Backend {
public:
    RoundBackend(const Plan& plan, std::uint32_t threads) : state_(plan), workers_(threads) {}

    std::string device() const override { return workers_.name(); }
    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        if (!is_set_)
            for_columns(state_.plan.lines, [&](std::uint32_t i) { cpu::set_free(state_, i); });
        is_set_ = true;
        state_.begin_round(draws);
        for_columns(draws.size(), [&](std::uint32_t i) { cpu::locate(state_, draws, i); });
        state_.end_locate();
    }

    // All draws at once, or part by part, in the order of the draws, where they crowd.
    void admit() override {
        const auto count = static_cast<std::uint32_t>(state_.candidates.size());
        std::uint32_t end = cpu::first_part(state_);
        if (end == count) return settle();
        Crowd<ModeState> crowd(state_);
        for (std::uint32_t begin = 0; begin < count; begin = end, end += std::min(end, count - end))
            admit_part(crowd, {begin, end});
        crowd.give_back(state_);
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
        return {samples_, survivors, state_.free_lengths, state_.place_width};
    }

    Snapshot snapshot() override { return state_.snapshot(); }
    void restore(const Snapshot& snapshot) override {
        state_.restore(snapshot);
        is_set_ = true;
    }

protected:
    // Takes from the places what the samples of a part cover, so that is_covered tells.
    virtual void take_out() = 0;

    // work(column) for all columns, where so much is to be done in all.
    template <typename Work>
    void for_columns(std::size_t amount, Work work) {
        workers_.for_columns(state_.columns, amount, work);
    }
    // The same for the round's candidates; true when work is true for all.
    template <typename Work>
    bool all_columns(Work work) {
        return workers_.all_columns(state_.columns, state_.candidates.size(), work);
    }

    // Asks whether to go on.
    void poll() const { workers_.poll(); }

    ModeState state_;

private:
    void settle() {
        while (!all_columns([&](std::uint32_t i) { return cpu::admit(state_, i); })) {
        }
    }

    void admit_part(Crowd<ModeState>& crowd, Part part) {
        const std::size_t count = part.end;
        for_columns(count, [&](std::uint32_t i) { crowd.screen(state_, i, part); });
        crowd.make_room(state_);
        for_columns(count, [&](std::uint32_t i) { crowd.move_in(state_, i, part); });
        state_.end_locate();
        settle();
        for_columns(count, [&](std::uint32_t i) { crowd.move_out(state_, i); });
        take_out();
    }

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    Workers workers_;
    bool is_set_ = false;                  // the places are set free in the first round
    std::vector<std::uint32_t> by_order_;  // the candidate admitted of each draw, or kNone
    std::vector<Sample> samples_;
};

}  // namespace lacuna::cpu

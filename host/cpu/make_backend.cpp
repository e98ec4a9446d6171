// The cpu backend: shares the columns out over threads (oneTBB).
#include "cpu/make_backend.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

#include "columns.h"
#include "cpu/state.h"
#include "portable/column.h"
#include "portable/fate.h"

// For a task's closure, which oneTBB copies and hands over unseen.
#define LACUNA_UNSEEN_BY_TSAN __attribute__((no_sanitize("thread"), noinline))

namespace lacuna::cpu {
namespace {

// So few draws are served faster by one thread than by waking another.
constexpr std::size_t kParallelDraws = 128;

class CpuBackend : public Backend {
public:
    CpuBackend(const Plan& plan, std::uint32_t threads)
        : state_(plan),
          threads_(threads != 0 ? static_cast<int>(threads) : tbb::info::default_concurrency()),
          allowed_(tbb::global_control::max_allowed_parallelism,
                   static_cast<std::size_t>(std::max(threads_, tbb::info::default_concurrency()))),
          arena_(threads_) {}

    std::string device() const override {
        return std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads");
    }

    void locate(std::span<const Draw> draws) override {
        state_.candidates.resize(draws.size());
        state_.fates.resize(draws.size());
        find_column_begins(state_.plan, state_.columns, draws, state_.column_begins);
        for_columns([&](std::uint32_t column) { cpu::locate(state_, draws, column); });
    }

    void admit() override {
        while (!all_columns([&](std::uint32_t column) { return cpu::admit(state_, column); })) {
        }
    }

    void subtract() override {
        while (!all_columns([&](std::uint32_t column) { return cpu::subtract(state_, column); }))
            state_.grow();
    }

    Round finish_round() override {
        by_order_.assign(state_.candidates.size(), kNone);
        for (std::uint32_t i = 0; i < by_order_.size(); ++i)
            if (state_.fates[i] == FATE_ADMITTED) by_order_[state_.candidates[i].order] = i;
        samples_.clear();
        for (const std::uint32_t i : by_order_)
            if (i != kNone) samples_.push_back({state_.candidates[i].x, state_.candidates[i].y});
        return {samples_, state_.free_lengths};
    }

    Snapshot snapshot() override {
        Snapshot snapshot{state_.capacity, {}, state_.candidates, state_.fates};
        for (std::uint32_t line = 0; line < state_.plan.lines; ++line) {
            const std::span<Span> spans = state_.slot(line).first(state_.span_counts[line]);
            snapshot.spans.emplace_back(spans.begin(), spans.end());
        }
        return snapshot;
    }

    void restore(const Snapshot& snapshot) override { state_.restore(snapshot); }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    template <typename Work>
    void for_columns(Work work) {
        if (threads_ == 1 || state_.candidates.size() < kParallelDraws) {
            for (std::uint32_t column = 0; column < state_.columns; ++column) work(column);
            return;
        }
        handover_.fetch_add(1, std::memory_order_release);
        arena_.execute([&] {
            tbb::parallel_for(std::uint32_t{0}, state_.columns,
                              [&](std::uint32_t column)
                                  LACUNA_UNSEEN_BY_TSAN { serve(column, work); });
        });
        handover_.load(std::memory_order_acquire);
    }

    // oneTBB hands memory over between threads by itself. It is said once more here because a
    // ThreadSanitizer that does not see into the library cannot know.
    template <typename Work>
    void serve(std::uint32_t column, Work& work) {
        handover_.load(std::memory_order_acquire);
        work(column);
        handover_.fetch_add(1, std::memory_order_release);
    }

    template <typename Work>
    bool all_columns(Work work) {
        std::atomic<bool> all{true};
        for_columns([&](std::uint32_t column) {
            if (!work(column)) all.store(false, std::memory_order_relaxed);
        });
        return all;
    }

    State state_;
    int threads_;
    tbb::global_control allowed_;  // more threads than cores, if that is what was asked for
    tbb::task_arena arena_;
    std::atomic<std::uint64_t> handover_{0};
    std::vector<std::uint32_t> by_order_;  // the sample of each draw, or kNone
    std::vector<Sample> samples_;
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return std::make_unique<CpuBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu

// Threads of the host (oneTBB), which work on numbered items such as columns.
#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <lacuna/lacuna.h>
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "base/threads.h"

// An attribute of closures that oneTBB copies from one thread to another. ThreadSanitizer does not
// see into oneTBB, so it would report that copy as a race.
#define LACUNA_UNSEEN_BY_TSAN __attribute__((no_sanitize("thread"), noinline))

namespace lacuna {

class Workers {
public:
    // 0: one thread for each core.
    explicit Workers(std::uint32_t threads)
        : threads_(threads != 0 ? static_cast<int>(threads) : tbb::info::default_concurrency()),
          arena_(threads_) {}

    std::string name() const {
        return std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads");
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(threads_); }
    void watch(std::function<bool()> may_go_on) { may_go_on_ = std::move(may_go_on); }

    // Throws Cancelled if the work is to stop.
    void poll() const {
        if (may_go_on_ && !may_go_on_()) throw Cancelled();
    }

    // Calls work(column) for all columns, in parallel if `amount`, the number of draws or bins in
    // all, is worth it. The calling thread asks now and then whether to go on; if not, the other
    // columns are skipped and Cancelled is thrown. Throws Unavailable if the system refuses
    // threads.
    template <typename Work>
    void for_columns(std::uint32_t columns, std::size_t amount, Work work) {
        cancelled_.store(false, std::memory_order_relaxed);
        const std::thread::id caller = std::this_thread::get_id();
        if (threads_ == 1 || columns == 1 || amount < kParallelAmount) {
            for (std::uint32_t column = 0; column < columns; ++column) serve(column, caller, work);
        } else {
            make_sure_of_threads(threads_);
            handover_.fetch_add(1, std::memory_order_release);
            arena_.execute([&] {
                tbb::parallel_for(std::uint32_t{0}, columns,
                                  [&](std::uint32_t column)
                                      LACUNA_UNSEEN_BY_TSAN { hand_over(column, caller, work); });
            });
            handover_.load(std::memory_order_acquire);
        }
        if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled();
    }

    // The same; returns whether work(column) returned true for all columns.
    template <typename Work>
    bool all_columns(std::uint32_t columns, std::size_t amount, Work work) {
        std::atomic<bool> all{true};
        for_columns(columns, amount, [&](std::uint32_t column) {
            if (!work(column)) all.store(false, std::memory_order_relaxed);
        });
        return all;
    }

private:
    // Fewer draws or bins than kParallelAmount take the calling thread less time than it takes to
    // wake another thread.
    static constexpr std::size_t kParallelAmount = 512;
    // The calling thread asks may_go_on_ at one column in kColumnsPerPoll. A column of the largest
    // sets takes some milliseconds, and asking takes a tenth of a microsecond.
    static constexpr std::uint32_t kColumnsPerPoll = 4;

    template <typename Work>
    void serve(std::uint32_t column, std::thread::id caller, Work& work) {
        if (cancelled_.load(std::memory_order_relaxed)) return;
        if (column % kColumnsPerPoll == 0 && may_go_on_ && std::this_thread::get_id() == caller &&
            !may_go_on_())
            cancelled_.store(true, std::memory_order_relaxed);
        work(column);
    }

    // oneTBB synchronises the memory of its threads, but ThreadSanitizer does not see that. Using
    // handover_ synchronises it again, for ThreadSanitizer alone.
    template <typename Work>
    void hand_over(std::uint32_t column, std::thread::id caller, Work& work) {
        handover_.load(std::memory_order_acquire);
        serve(column, caller, work);
        handover_.fetch_add(1, std::memory_order_release);
    }

    int threads_;
    tbb::task_arena arena_;
    std::atomic<std::uint64_t> handover_{0};
    std::function<bool()> may_go_on_;
    std::atomic<bool> cancelled_{false};
};

}  // namespace lacuna

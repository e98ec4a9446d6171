// Ranks that are threads of one process, for tests: mailboxes and a barrier.
#pragma once

#include <atomic>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <thread>
#include <vector>

#include "ranks/ranks.h"

namespace lacuna::tests {

// The state common to all ranks of a run. All must make the same calls, or the run never ends.
class Ring {
public:
    explicit Ring(std::uint32_t count)
        : mail_(count), words_(count), barrier_(static_cast<std::ptrdiff_t>(count)) {}

    std::uint32_t count() const { return static_cast<std::uint32_t>(mail_.size()); }
    std::uint64_t bytes() const { return bytes_; }  // exchanged by neighbours

private:
    friend class ThreadRank;

    std::vector<Sides> mail_;
    std::vector<std::vector<std::uint64_t>> words_;
    std::barrier<> barrier_;
    std::atomic<std::uint64_t> bytes_ = 0;
};

class ThreadRank : public Ranks {
public:
    ThreadRank(Ring& ring, std::uint32_t rank) : ring_(ring), rank_(rank) {}

    std::uint32_t rank() const override { return rank_; }
    std::uint32_t count() const override { return ring_.count(); }

    Sides exchange(const Sides& sent) override {
        ring_.mail_[rank_] = sent;
        ring_.bytes_ += sent.low.size() + sent.high.size();
        ring_.barrier_.arrive_and_wait();
        const std::uint32_t count = ring_.count();
        Sides got{ring_.mail_[(rank_ + count - 1) % count].high,
                  ring_.mail_[(rank_ + 1) % count].low};
        ring_.barrier_.arrive_and_wait();
        return got;
    }
    void sum(std::span<std::uint64_t> values) override {
        ring_.words_[rank_].assign(values.begin(), values.end());
        ring_.barrier_.arrive_and_wait();
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = 0;
            for (const std::vector<std::uint64_t>& of_rank : ring_.words_) values[i] += of_rank[i];
        }
        ring_.barrier_.arrive_and_wait();
    }
    std::uint64_t sum_below(std::uint64_t value) override {
        ring_.words_[rank_] = {value};
        ring_.barrier_.arrive_and_wait();
        std::uint64_t below = 0;
        for (std::uint32_t i = 0; i < rank_; ++i) below += ring_.words_[i].front();
        ring_.barrier_.arrive_and_wait();
        return below;
    }

private:
    Ring& ring_;
    std::uint32_t rank_;
};

// Calls run(rank) once for each rank, in a thread of its own. It must throw on all ranks or on
// none: the first rank's exception is thrown again.
template <typename Run>
void on_threads(Ring& ring, Run run) {
    std::vector<std::exception_ptr> thrown(ring.count());
    std::vector<std::thread> threads;
    for (std::uint32_t i = 0; i < ring.count(); ++i)
        threads.emplace_back([&, i] {
            ThreadRank rank(ring, i);
            try {
                run(rank);
            } catch (...) {
                thrown[i] = std::current_exception();
            }
        });
    for (std::thread& thread : threads) thread.join();
    if (thrown.front()) std::rethrow_exception(thrown.front());
}

}  // namespace lacuna::tests

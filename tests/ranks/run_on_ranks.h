// A whole set, made by ranks that are threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "plan/plan.h"
#include "ranks/generate_on_ranks.h"
#include "ranks/thread_ranks.h"

namespace lacuna::tests {

// Puts all ranks' samples in the order of admission.
class SharedSink {
public:
    void add(std::uint32_t round, std::span<const Sample> samples,
             std::span<const std::uint32_t> numbers) {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (std::size_t i = 0; i < samples.size(); ++i)
            all_.push_back({std::uint64_t{round} << 32 | numbers[i], samples[i]});
    }
    std::vector<Sample> in_order(std::uint64_t limit) {
        std::sort(all_.begin(), all_.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Sample> samples;
        for (const auto& [key, sample] : all_)
            if (samples.size() < limit) samples.push_back(sample);
        return samples;
    }

private:
    std::mutex mutex_;
    std::vector<std::pair<std::uint64_t, Sample>> all_;
};

class RankSink : public Sink {
public:
    explicit RankSink(SharedSink& shared) : shared_(shared) {}
    void begin(const Plan&) override {}
    void take(std::span<const Sample> samples, std::span<const std::uint32_t> numbers,
              std::uint32_t) override {
        shared_.add(round_++, samples, numbers);
    }

private:
    SharedSink& shared_;
    std::uint32_t round_ = 0;
};

struct MadeOnRanks {
    std::vector<Sample> samples;
    OutcomeOnRanks outcome;              // from rank 0
    std::vector<Border::Tally> tallies;  // of each rank
    std::uint64_t bytes = 0;             // sent between neighbours
};

// Each rank has one thread. The backends are made one after another, because drivers compile then;
// the ranks have those named in turn.
inline MadeOnRanks run_on_ranks(const Plan& plan, std::uint32_t count,
                                const std::vector<std::string>& names,
                                std::uint32_t depth = Border::kDepth) {
    Ring ring(count);
    SharedSink sink;
    MadeOnRanks made;
    made.tallies.resize(count);
    std::vector<Strip> strips;
    std::vector<std::unique_ptr<Backend>> backends;
    for (std::uint32_t i = 0; i < count; ++i) strips.push_back(strip_of(plan, i, count));
    for (std::size_t i = 0; i < count; ++i)
        backends.push_back(make_backend(names[i % names.size()], strips[i].plan));
    on_threads(ring, [&](Ranks& rank) {
        RankSink own(sink);
        Observer nobody;
        const OutcomeOnRanks outcome = generate_on_ranks(
            plan, strips[rank.rank()], *backends[rank.rank()], rank, own, nobody, depth);
        made.tallies[rank.rank()] = outcome.border;
        if (rank.rank() == 0) made.outcome = outcome;
    });
    made.bytes = ring.bytes();
    made.samples = sink.in_order(plan.limit);
    return made;
}

}  // namespace lacuna::tests

// lacuna::sample_many: batches of small sets in parallel, larger ones one after the other.
#include <lacuna/many.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "backends/backends.h"
#include "base/polling.h"
#include "base/threads.h"
#include "plan/checked_request.h"

namespace lacuna {
namespace {

// Most points of a set made on one thread. It takes 20 ms, for which a cancelled batch may go on.
constexpr double kSmallSet = 20000;
// Sets in a batch, for each thread: enough to keep threads busy, few enough for memory.
constexpr std::size_t kSetsAThread = 64;

// Whether sets are small: one set on each thread is then faster than one set on all threads.
bool is_small(const Request& request) {
    const std::string backend = wanted_backend(request.run_on.backend);
    if (backend != "auto" && backend != "cpu") return false;
    if (request.paper2011.round_size != 0 || request.paper2011.uniform_x) return false;
    if (request.field != nullptr) return false;
    if (request.count) return static_cast<double>(*request.count) <= kSmallSet;
    // Invalid requests are left to sample(), which refuses them.
    return request.radius && *request.radius > 0 && request.domain.shorter_side() > 0 &&
           expected_count(request.domain, *request.radius) <= kSmallSet;
}

Request with_seed(const Request& request, std::uint64_t seed) {
    Request one = request;
    one.seed = seed;
    return one;
}

// Asks the user's observer, on the calling thread, whether to go on; gives all threads the answer.
class OfAll {
public:
    OfAll(Observer& observer, std::size_t sets) : observer_(observer), sets_(sets) {}

    bool keep_going() {
        if (std::this_thread::get_id() == caller_ && !observer_.keep_going({done_, sets_, 0}))
            stopped_.store(true, std::memory_order_relaxed);
        return !stopped_.load(std::memory_order_relaxed);
    }
    void add_one() { ++done_; }  // on the calling thread

private:
    Observer& observer_;
    std::uint64_t sets_;
    std::uint64_t done_ = 0;
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<bool> stopped_ = false;
};

class OfOne : public Observer {
public:
    explicit OfOne(OfAll& all) : all_(all) {}
    bool keep_going(const Progress&) override { return all_.keep_going(); }

private:
    OfAll& all_;
};

Result made(const Resolved& resolved, std::uint64_t seed, OfAll& all) {
    OfOne observer(all);
    Result set = sample(with_seed(resolved.request, seed), observer);
    set.edge = resolved.edge;
    return set;
}

void ask_all(OfAll& all) {
    ask();
    if (!all.keep_going()) throw Cancelled();
}

void one_by_one(const Resolved& resolved, std::span<const std::uint64_t> seeds, const TakeSet& take,
                OfAll& all) {
    for (const std::uint64_t seed : seeds) {
        ask_all(all);
        take(seed, made(resolved, seed, all));
        all.add_one();
    }
}

void in_batches(const Resolved& resolved, std::span<const std::uint64_t> seeds, const TakeSet& take,
                OfAll& all) {
    const std::uint32_t wanted = resolved.request.run_on.threads;
    const int threads = wanted == 0 ? tbb::info::default_concurrency() : static_cast<int>(wanted);
    make_sure_of_threads(threads);
    tbb::task_arena arena(threads);
    Resolved single = resolved;
    single.request.run_on.threads = 1;
    const std::size_t batch = kSetsAThread * static_cast<std::size_t>(threads);
    std::vector<std::optional<Result>> results(std::min(batch, seeds.size()));
    for (std::size_t begin = 0; begin < seeds.size(); begin += batch) {
        const std::size_t size = std::min(batch, seeds.size() - begin);
        ask_all(all);
        arena.execute([&] {
            tbb::parallel_for(
                std::size_t{0}, size,
                [&](std::size_t i) { results[i] = made(single, seeds[begin + i], all); },
                tbb::simple_partitioner());
        });
        for (std::size_t i = 0; i < size; ++i) {
            ask_all(all);
            take(seeds[begin + i], std::move(*results[i]));
            results[i].reset();
            all.add_one();
        }
    }
}

}  // namespace

void sample_many(const Request& request, std::span<const std::uint64_t> seeds,
                 const TakeSet& take) {
    Observer nobody;
    sample_many(request, seeds, take, nobody);
}

void sample_many(const Request& request, std::span<const std::uint64_t> seeds, const TakeSet& take,
                 Observer& observer) {
    const Resolved resolved = resolve(request);
    check_request(resolved.request);  // also if there are no seeds yet
    OfAll all(observer, seeds.size());
    // The threads are checked by sample() itself, which would come too late here.
    const bool can_share = request.run_on.threads != 1 && request.run_on.threads <= kMostThreads;
    (can_share && is_small(request) ? in_batches : one_by_one)(resolved, seeds, take, all);
}

}  // namespace lacuna

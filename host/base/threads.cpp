// Starts threads and ends them again, to learn whether the system allows that number. Limits the
// threads of oneTBB to it.
#include "base/threads.h"

#include <lacuna/lacuna.h>
#include <pthread.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <atomic>
#include <cstddef>
#include <latch>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

namespace lacuna {
namespace {

// Twice the stack of a oneTBB thread: glibc aborts when a new thread finds no memory.
constexpr std::size_t kStackBytes = std::size_t{8} << 20U;

void* wait_at(void* gate) {
    static_cast<std::latch*>(gate)->wait();
    return nullptr;
}

// All threads exist at the same time, as later in the run. Returns the system's error, or 0.
int try_to_make(int threads) {
    std::vector<pthread_t> made;
    made.reserve(static_cast<std::size_t>(threads));
    pthread_attr_t attributes{};
    int error = pthread_attr_init(&attributes);
    if (error != 0) return error;
    error = pthread_attr_setstacksize(&attributes, kStackBytes);
    std::latch gate(1);
    while (error == 0 && made.size() < static_cast<std::size_t>(threads)) {
        pthread_t thread{};
        error = pthread_create(&thread, &attributes, wait_at, &gate);
        if (error == 0) made.push_back(thread);
    }
    gate.count_down();
    for (const pthread_t thread : made) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return error;
}

// Lets oneTBB keep this many threads, the caller included, if that is more than one for each core.
// Without this call it keeps at most one for each core, and prints a warning when asked for more.
void allow_threads(int threads) {
    if (threads <= tbb::info::default_concurrency()) return;
    // The last control is never destroyed. Of several controls oneTBB obeys the smallest, and the
    // assignment makes the new one before it destroys the old one.
    using Control = std::unique_ptr<tbb::global_control>;
    static Control& kept = *std::make_unique<Control>().release();
    kept = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                 static_cast<std::size_t>(threads));
}

}  // namespace

void make_sure_of_threads(int threads) {
    static std::atomic<int> sure_of = 1;
    if (threads <= sure_of) return;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    if (threads <= sure_of) return;
    // oneTBB keeps the threads that it has made, so only the additional ones are tried.
    const int error = try_to_make(threads - sure_of);
    if (error != 0)
        throw Unavailable("the system does not make " + std::to_string(threads) + " threads (" +
                          std::generic_category().message(error) +
                          "): allow more of them or more memory (ulimit -u, ulimit -v), or use "
                          "fewer (--threads, taskset)");
    allow_threads(threads);
    sure_of = threads;
}

void make_sure_of_threads() {
    make_sure_of_threads(tbb::info::default_concurrency());
}

}  // namespace lacuna

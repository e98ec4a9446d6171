// Work that may take long asks now and then whether to go on. The name poll.h would hide the
// system's header.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace lacuna {

// Throws Cancelled if the work is to stop.
using Poll = std::function<void()>;

inline void nobody_asks() {}

// Asks the thread's scopes (lacuna/cancel.h), if there are any. Throws Cancelled if the work is to
// stop.
void ask();

constexpr std::size_t kBetweenPolls = 65536;  // pixels or points: about a millisecond

// Calls work(i) for each i in [0, count), in order, and polls now and then. One call takes about as
// long as the work on `pixels` pixels.
template <typename Work>
void for_each_polled(std::size_t count, const Poll& poll, Work work, std::size_t pixels = 1) {
    const std::size_t run = std::max<std::size_t>(1, kBetweenPolls / pixels);
    for (std::size_t begin = 0; begin < count; begin += run) {
        poll();
        const std::size_t end = std::min(count, begin + run);
        for (std::size_t i = begin; i < end; ++i) work(i);
    }
}

// For loops that are no simple count: asks once in a while, as the thread's work adds up. `pixels`
// is the work since the last call, which takes as long as that on this many pixels.
void ask_after(std::size_t pixels = 1);

}  // namespace lacuna

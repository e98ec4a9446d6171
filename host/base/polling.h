// Preparations, which may take seconds before the first round, ask now and then whether to go on.
// The name poll.h would hide the system's header.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace lacuna {

// Throws Cancelled if the work is to stop.
using Poll = std::function<void()>;

inline void nobody_asks() {}

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

}  // namespace lacuna

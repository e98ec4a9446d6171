// How what is prepared asks whether to go on: it may take seconds before the first round. Not
// poll.h, which would hide the one of the system.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace lacuna {

// Asks whether to go on; throws Cancelled if not.
using Poll = std::function<void()>;

inline void nobody_asks() {}

constexpr std::size_t kBetweenPolls = 65536;  // pixels or points: about a millisecond

// Calls work(i) for i from 0 to count, in order, and polls now and then: each counts as much as so
// many pixels.
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

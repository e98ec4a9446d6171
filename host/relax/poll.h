// How what is prepared asks whether to go on: it may take seconds before the first iteration.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace lacuna::relaxing {

// Asks whether to go on; throws Cancelled if not.
using Poll = std::function<void()>;

inline void nobody_asks() {}

// Calls work(i) for i from 0 to count, in order, and polls now and then.
template <typename Work>
void for_each_polled(std::size_t count, const Poll& poll, Work work) {
    constexpr std::size_t kBetweenPolls = 65536;  // about a millisecond
    for (std::size_t begin = 0; begin < count; begin += kBetweenPolls) {
        poll();
        const std::size_t end = std::min(count, begin + kBetweenPolls);
        for (std::size_t i = begin; i < end; ++i) work(i);
    }
}

}  // namespace lacuna::relaxing

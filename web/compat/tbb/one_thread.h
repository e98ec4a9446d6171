// Replaces the parts of oneTBB that Lacuna uses, without threads: a web page has threads only if
// its server sends two special headers, which static hosts seldom do. Loops run on the calling
// thread, in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tbb {

template <typename Index, typename Body>
void parallel_for(Index begin, Index end, const Body& body) {
    for (; begin < end; ++begin) body(begin);
}

template <typename Range, typename Body>
void parallel_for(const Range& range, const Body& body) {
    body(range);
}

class simple_partitioner {};

template <typename Index, typename Body>
void parallel_for(Index begin, Index end, const Body& body, simple_partitioner) {
    parallel_for(begin, end, body);
}

template <typename... Bodies>
void parallel_invoke(const Bodies&... bodies) {
    (bodies(), ...);
}

template <typename Iterator, typename Less>
void parallel_sort(Iterator begin, Iterator end, const Less& less) {
    std::sort(begin, end, less);
}

template <typename Value>
class blocked_range {
public:
    blocked_range(Value begin, Value end, std::size_t = 1) : begin_(begin), end_(end) {}
    Value begin() const { return begin_; }
    Value end() const { return end_; }

private:
    Value begin_;
    Value end_;
};

class task_arena {
public:
    explicit task_arena(int) {}
    template <typename Body>
    decltype(auto) execute(const Body& body) {
        return body();
    }
};

class global_control {
public:
    enum parameter { max_allowed_parallelism };
    global_control(parameter, std::size_t) {}
};

// The value of the only thread.
template <typename Value>
class enumerable_thread_specific {
public:
    template <typename... Arguments>
    explicit enumerable_thread_specific(Arguments&&... arguments)
        : value_(std::forward<Arguments>(arguments)...) {}
    Value& local() { return value_; }
    Value* begin() { return &value_; }
    Value* end() { return &value_ + 1; }

private:
    Value value_;
};

namespace info {
inline int default_concurrency() {
    return 1;
}
}  // namespace info

namespace this_task_arena {
inline int max_concurrency() {
    return 1;
}
}  // namespace this_task_arena

}  // namespace tbb

namespace oneapi {
namespace tbb = ::tbb;
}

// Large pages for large arrays: fewer faults when they are first written, fewer misses later.
#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace lacuna {

// Asks the system for large pages in memory that nobody has written to yet. Where there are none,
// or the array is small, nothing happens.
template <typename T>
void ask_for_large_pages(T* array, std::size_t entries) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t kLargePage = std::size_t{1} << 21;
    void* first = array;
    std::size_t bytes = entries * sizeof(T);
    if (std::align(kLargePage, kLargePage, first, bytes) != nullptr)
        madvise(first, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
#else
    static_cast<void>(array), static_cast<void>(entries);
#endif
}

// An array of trivial entries that are all zeros, on lines of the cache: in pages that are touched
// when they are first written to, by whichever thread that is.
template <typename T>
class ZeroedArray {
public:
    explicit ZeroedArray(std::size_t entries) {
        constexpr std::size_t kLine = 64;
        std::size_t bytes = entries * sizeof(T) + kLine;
        memory_.reset(std::calloc(bytes, 1));
        if (memory_ == nullptr) throw std::bad_alloc();
        void* first = memory_.get();
        entries_ = static_cast<T*>(std::align(kLine, entries * sizeof(T), first, bytes));
        ask_for_large_pages(entries_, entries);
    }
    T& operator[](std::size_t i) { return entries_[i]; }
    const T& operator[](std::size_t i) const { return entries_[i]; }

private:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    static_assert(std::is_trivially_copyable_v<T>);

    std::unique_ptr<void, Free> memory_;
    T* entries_;
};

}  // namespace lacuna

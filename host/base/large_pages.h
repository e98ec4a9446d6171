// Large pages for large arrays: fewer page faults on first use, fewer TLB misses later.
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

// Asks the system for large pages; the memory must not have been written to yet. Does nothing for
// small arrays and on systems without large pages.
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

// A zeroed array of trivial entries, aligned to a cache line. The system provides each page when a
// thread first writes to it.
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

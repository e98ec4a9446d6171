// Room at the end of long vectors, whose pages all threads touch together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/large_pages.h"
#include "base/workers.h"

namespace lacuna {

// Reserves room for `more` entries after the last one. The system clears a page when it is first
// written to, which takes one thread six times as long as filling it.
template <typename T>
void make_room_to_append(std::vector<T>& entries, std::size_t more, Workers& workers) {
    constexpr std::size_t kPage = std::size_t{1} << 12;
    constexpr std::size_t kPagesATime = 512;
    if (entries.capacity() < entries.size() + more) {
        entries.reserve(std::max(entries.size() + more, 2 * entries.capacity()));
        ask_for_large_pages(entries.data() + entries.size(), entries.capacity() - entries.size());
    }
    auto* const room = reinterpret_cast<std::byte*>(entries.data() + entries.size());
    const std::size_t pages = more * sizeof(T) / kPage;
    workers.for_columns(static_cast<std::uint32_t>(pages / kPagesATime), pages,
                        [&](std::uint32_t column) {
                            std::byte* const first = room + column * kPagesATime * kPage;
                            for (std::size_t page = 0; page < kPagesATime; ++page)
                                first[page * kPage] = std::byte{0};
                        });
}

}  // namespace lacuna

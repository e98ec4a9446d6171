// Insertion sort, which is fast where items are almost sorted.
#pragma once

#include <cstddef>
#include <span>

namespace lacuna {

// Equal items keep their order.
template <typename Item, typename Before>
void insertion_sort(std::span<Item> items, Before comes_before) {
    for (std::size_t i = 1; i < items.size(); ++i) {
        const Item moved = items[i];
        std::size_t to = i;
        for (; to > 0 && comes_before(moved, items[to - 1]); --to) items[to] = items[to - 1];
        items[to] = moved;
    }
}

}  // namespace lacuna

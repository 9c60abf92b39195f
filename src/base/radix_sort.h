#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace inkedge::base {

/// Sorts by an unsigned key; what has the same stays in its order. By 8 bits at a time, the lowest first: as many
/// places in memory as caches and their tables hold. O(n), quicker where all keys have some of their bytes in common.
/// @param keyOf  of an item
template <class Item, class KeyOf>
void radixSort(std::vector<Item>& items, KeyOf keyOf) {
    constexpr std::size_t few = 4096;
    if (items.size() < few) {
        std::ranges::stable_sort(items, {}, keyOf);
        return;
    }
    constexpr std::size_t digits = sizeof(keyOf(items.front()));
    const auto digitOf = [&](const Item& item, std::size_t digit) { return keyOf(item) >> (8 * digit) & 0xFFU; };
    std::array<std::array<std::size_t, 256>, digits> counts{};
    for (const Item& item : items)
        for (std::size_t digit = 0; digit < digits; ++digit) ++counts[digit][digitOf(item, digit)];
    std::vector<Item> sorted(items.size());
    for (std::size_t digit = 0; digit < digits; ++digit) {
        std::array<std::size_t, 256>& next = counts[digit];
        if (next[digitOf(items.front(), digit)] == items.size()) continue;
        std::exclusive_scan(next.begin(), next.end(), next.begin(), std::size_t{0});
        for (const Item& item : items) sorted[next[digitOf(item, digit)]++] = item;
        items.swap(sorted);
    }
}

}  // namespace inkedge::base

#include "mesh/z_order.h"

#include <cstddef>
#include <numeric>

namespace inkedge::mesh {

// A radix sort by 16 bits at a time, the lowest first.
void sortByKey(std::vector<ZOrderKey>& keys) {
    constexpr std::size_t few = 4096;
    if (keys.size() < few) {
        std::ranges::stable_sort(keys, {}, &ZOrderKey::key);
        return;
    }
    std::vector<ZOrderKey> sorted(keys.size());
    std::vector<std::uint32_t> begin(65537);
    for (std::uint32_t shift = 0; shift < 64; shift += 16) {
        std::ranges::fill(begin, 0U);
        for (const ZOrderKey& k : keys) ++begin[(k.key >> shift & 0xFFFFU) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const ZOrderKey& k : keys) sorted[begin[k.key >> shift & 0xFFFFU]++] = k;
        keys.swap(sorted);
    }
}

}  // namespace inkedge::mesh

#include "scene/topology.h"

#include <algorithm>

namespace inkedge {

std::vector<std::uint32_t> twinHalfEdges(std::span<const std::uint32_t> corners, std::uint32_t pointCount) {
    struct Entry {
        std::uint32_t greaterPoint;
        std::uint32_t halfEdge;
    };
    const auto halfEdgeCount = static_cast<std::uint32_t>(corners.size());
    const auto ends = [&](std::uint32_t h) { return std::minmax(corners[h], corners[nextHalfEdge(h)]); };

    // Counting sort by the lesser point; the few edges that share it are then sorted by the greater one.
    std::vector<std::uint32_t> begin(pointCount + 1, 0);
    for (std::uint32_t h = 0; h < halfEdgeCount; ++h) ++begin[ends(h).first + 1];
    for (std::uint32_t p = 0; p < pointCount; ++p) begin[p + 1] += begin[p];
    std::vector<Entry> entries(halfEdgeCount);
    std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
    for (std::uint32_t h = 0; h < halfEdgeCount; ++h) entries[fill[ends(h).first]++] = {ends(h).second, h};

    std::vector<std::uint32_t> twins(halfEdgeCount, noHalfEdge);
    for (std::uint32_t p = 0; p < pointCount; ++p) {
        const auto first = entries.begin() + begin[p];
        const auto last = entries.begin() + begin[p + 1];
        std::sort(first, last, [](const Entry& a, const Entry& b) {
            return a.greaterPoint != b.greaterPoint ? a.greaterPoint < b.greaterPoint : a.halfEdge < b.halfEdge;
        });
        for (auto run = first; run != last;) {
            const auto end =
                std::find_if(run, last, [&](const Entry& e) { return e.greaterPoint != run->greaterPoint; });
            if (end - run == 2) {
                twins[run[0].halfEdge] = run[1].halfEdge;
                twins[run[1].halfEdge] = run[0].halfEdge;
            }
            run = end;
        }
    }
    return twins;
}

}  // namespace inkedge

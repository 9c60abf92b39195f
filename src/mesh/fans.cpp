#include "mesh/fans.h"

#include "base/union_find.h"

namespace inkedge::mesh {

std::vector<std::uint32_t> findFans(const MeshTopology& topology) {
    const auto corners = static_cast<std::uint32_t>(topology.points.size());
    base::UnionFind fans{corners};
    for (std::uint32_t h = 0; h < corners; ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin) || topology.creases[h]) continue;
        const TwinEnds ends = endsOfTwin(topology, h, twin);
        fans.unite(h, ends.atStart);
        fans.unite(nextHalfEdge(h), ends.atEnd);
    }
    std::vector<std::uint32_t> first(corners);
    for (std::uint32_t c = 0; c < corners; ++c) first[c] = fans.root(c);
    return first;
}

}  // namespace inkedge::mesh

#include "scene/closed_surface.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "scene/union_find.h"

namespace inkedge {
namespace {

bool isCollapsed(const MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

// Of the tetrahedron of a face and the mesh's origin, times 6.
double signedVolume(const Mesh& mesh, std::uint32_t t) {
    const auto corner = [&](std::uint32_t k) { return glm::dvec3{mesh.positions[mesh.indices[3 * std::size_t{t} + k]]}; };
    return glm::dot(corner(0), glm::cross(corner(1), corner(2)));
}

}  // namespace

bool isClosedOutward(const Mesh& mesh, const MeshTopology& topology) {
    const auto count = static_cast<std::uint32_t>(topology.originals.size());
    UnionFind parts{count};
    for (std::uint32_t t = 0; t < count; ++t) {
        if (isCollapsed(topology, t)) continue;
        if (topology.originals[t] != t) return false;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t twin = topology.twins[h];
            const bool opposite = isHalfEdge(twin) && topology.points[h] != topology.points[twin];
            if (!opposite) return false;
            parts.unite(t, twin / 3);
        }
    }
    std::vector<double> volumes(count, 0.0);
    for (std::uint32_t t = 0; t < count; ++t) volumes[parts.root(t)] += signedVolume(mesh, t);
    for (std::uint32_t t = 0; t < count; ++t)
        if (parts.root(t) == t && !isCollapsed(topology, t) && !(volumes[t] > 0.0)) return false;
    return true;
}

}  // namespace inkedge

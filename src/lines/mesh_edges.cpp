#include "lines/mesh_edges.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "scene/union_find.h"

namespace inkedge::lines {
namespace {

bool takesPart(const MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return topology.originals[t] == t && p[0] != p[1] && p[1] != p[2] && p[2] != p[0];
}

bool sameNormals(const Mesh& mesh, const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    constexpr float same = 0.9999F;  // cosine: under a degree
    const bool opposite = topology.points[halfEdge] != topology.points[twin];
    const std::uint32_t atStart = opposite ? nextHalfEdge(twin) : twin;
    const std::uint32_t atEnd = opposite ? twin : nextHalfEdge(twin);
    const auto agree = [&](std::uint32_t a, std::uint32_t b) {
        if (mesh.indices[a] == mesh.indices[b]) return true;
        return glm::dot(mesh.normals[mesh.indices[a]], mesh.normals[mesh.indices[b]]) > same;
    };
    return agree(halfEdge, atStart) && agree(nextHalfEdge(halfEdge), atEnd);
}

// The half-edges of edges that many faces share, an edge's next to each other.
void collectMany(const MeshTopology& topology, MeshEdges& edges) {
    auto& many = edges.many;
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.twins[h] == manyHalfEdges) many.push_back(h);
    const auto ends = [&](std::uint32_t h) { return std::minmax(topology.points[h], topology.points[nextHalfEdge(h)]); };
    std::ranges::sort(many, [&](std::uint32_t a, std::uint32_t b) {
        const auto ea = ends(a);
        const auto eb = ends(b);
        if (ea.first != eb.first) return ea.first < eb.first;
        if (ea.second != eb.second) return ea.second < eb.second;
        return a < b;
    });
    for (std::uint32_t i = 0; i < many.size(); ++i)
        if (i == 0 || ends(many[i]) != ends(many[i - 1])) edges.manyBegins.push_back(i);
    edges.manyBegins.push_back(static_cast<std::uint32_t>(many.size()));
}

double signedVolume(const Mesh& mesh, std::uint32_t t) {
    const auto corner = [&](std::uint32_t k) { return glm::dvec3{mesh.positions[mesh.indices[3 * std::size_t{t} + k]]}; };
    return glm::dot(corner(0), glm::cross(corner(1), corner(2)));
}

std::vector<std::int8_t> findClosedParts(const Mesh& mesh, const MeshTopology& topology) {
    const auto count = static_cast<std::uint32_t>(topology.originals.size());
    UnionFind parts{count};
    std::vector<bool> open(count, false);
    for (std::uint32_t t = 0; t < count; ++t) {
        if (!takesPart(topology, t)) continue;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t twin = topology.twins[h];
            if (!isHalfEdge(twin)) {
                open[t] = true;
                continue;
            }
            if (topology.points[h] == topology.points[twin]) open[t] = true;
            parts.unite(t, twin / 3);
        }
    }
    std::vector<double> volumes(count, 0.0);
    for (std::uint32_t t = 0; t < count; ++t) {
        if (!takesPart(topology, t)) continue;
        if (open[t]) open[parts.root(t)] = true;
        volumes[parts.root(t)] += signedVolume(mesh, t);
    }
    std::vector<std::int8_t> closed(count, 0);
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t root = parts.root(t);
        if (!takesPart(topology, t) || open[root] || volumes[root] == 0.0) continue;
        closed[t] = volumes[root] > 0.0 ? 1 : -1;
    }
    return closed;
}

}  // namespace

MeshEdges findEdges(const Mesh& mesh, const MeshTopology& topology) {
    MeshEdges edges;
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (isHalfEdge(twin) && h < twin) {
            MeshEdges::Shared& shared = edges.shared;
            if (topology.creases[h]) edges.creases.push_back(static_cast<std::uint32_t>(shared.halfEdges.size()));
            shared.faces.push_back(h / 3);
            shared.faces.push_back(twin / 3);
            shared.halfEdges.push_back(h);
            shared.against.push_back(topology.points[h] == topology.points[twin] ? 1 : 0);
            shared.split.push_back(sameNormals(mesh, topology, h, twin) ? 0 : 1);
        }
    }
    collectMany(topology, edges);
    edges.faceNormals = makeFaceNormals(mesh);
    edges.closed = findClosedParts(mesh, topology);
    return edges;
}

}  // namespace inkedge::lines

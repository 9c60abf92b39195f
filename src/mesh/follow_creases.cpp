#include "mesh/follow_creases.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/geometric.hpp>

#include "base/union_find.h"

namespace inkedge::mesh {
namespace {

constexpr double straightCosine = -0.5;  // between the directions in which two edges of one line leave their point

// One end of an edge.
struct End {
    std::uint32_t point;
    std::uint32_t halfEdge;
    glm::dvec3 direction;  // unit, from the point along the edge
};

std::array<End, 2> endsOf(const Mesh& mesh, const MeshTopology& topology, std::uint32_t h) {
    const std::uint32_t next = nextHalfEdge(h);
    const glm::dvec3 along =
        glm::dvec3{mesh.positions[mesh.indices[next]]} - glm::dvec3{mesh.positions[mesh.indices[h]]};
    const double length = glm::length(along);
    const glm::dvec3 direction = length > 0.0 ? along / length : glm::dvec3{0.0};
    return {End{topology.points[h], h, direction}, End{topology.points[next], h, -direction}};
}

std::vector<End>::const_iterator firstAt(const std::vector<End>& ends, std::uint32_t point) {
    return std::ranges::lower_bound(ends, point, {}, &End::point);
}

}  // namespace

std::vector<bool> standAlone(const MeshTopology& topology, std::span<const std::uint32_t> halfEdges) {
    constexpr std::uint32_t maxAlone = 3;
    base::UnionFind groups{topology.pointCount};
    for (const std::uint32_t h : halfEdges) groups.unite(topology.points[h], topology.points[nextHalfEdge(h)]);
    std::vector<std::uint32_t> counts(topology.pointCount, 0);  // by root
    for (const std::uint32_t h : halfEdges) ++counts[groups.root(topology.points[h])];
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        if (isHalfEdge(topology.twins[h]) && !topology.creases[h]) continue;
        for (const std::uint32_t c : {h, nextHalfEdge(h)}) counts[groups.root(topology.points[c])] += maxAlone;
    }
    std::vector<bool> alone;
    alone.reserve(halfEdges.size());
    for (const std::uint32_t h : halfEdges) alone.push_back(counts[groups.root(topology.points[h])] <= maxAlone);
    return alone;
}

void followCreases(const Mesh& mesh, std::span<const std::uint32_t> doubtful, MeshTopology& topology) {
    if (doubtful.empty()) return;
    std::vector<End> ends;  // of doubtful edges, by their points
    for (const std::uint32_t h : doubtful)
        for (const End& end : endsOf(mesh, topology, h)) ends.push_back(end);
    std::ranges::sort(ends, {}, &End::point);

    std::vector<std::uint32_t> sure;  // creases whose ends are yet to be looked at
    const auto carryOn = [&](const End& crease) {
        for (auto end = firstAt(ends, crease.point); end != ends.end() && end->point == crease.point; ++end) {
            const std::uint32_t h = end->halfEdge;
            if (topology.creases[h] || glm::dot(end->direction, crease.direction) > straightCosine) continue;
            topology.creases[h] = topology.creases[topology.twins[h]] = true;
            sure.push_back(h);
        }
    };
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.creases[h] && topology.twins[h] > h) sure.push_back(h);
    while (!sure.empty()) {
        const std::uint32_t h = sure.back();
        sure.pop_back();
        for (const End& end : endsOf(mesh, topology, h)) carryOn(end);
    }
}

void extendCreases(const Mesh& mesh, std::span<const std::uint32_t> weak, MeshTopology& topology) {
    if (weak.empty()) return;
    std::vector<End> ends;  // of weak edges, by their points
    for (const std::uint32_t h : weak)
        for (const End& end : endsOf(mesh, topology, h)) ends.push_back(end);
    std::ranges::sort(ends, {}, &End::point);

    std::vector<std::uint8_t> creasesAt(topology.pointCount, 0);  // up to 2: more do not matter
    const auto count = [&](std::uint32_t point) { creasesAt[point] = std::min<std::uint8_t>(creasesAt[point] + 1, 2); };
    std::vector<std::uint32_t> sure;  // creases whose ends are yet to be looked at
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        if (!topology.creases[h] || topology.twins[h] < h) continue;
        sure.push_back(h);
        for (const End& end : endsOf(mesh, topology, h)) count(end.point);
    }
    while (!sure.empty()) {
        const std::uint32_t last = sure.back();
        sure.pop_back();
        for (const End& tip : endsOf(mesh, topology, last)) {
            if (creasesAt[tip.point] > 1) continue;
            const End* best = nullptr;
            double straightest = straightCosine;
            for (auto end = firstAt(ends, tip.point); end != ends.end() && end->point == tip.point; ++end) {
                const double cosine = glm::dot(end->direction, tip.direction);
                if (cosine <= straightest) straightest = cosine, best = &*end;
            }
            if (best == nullptr) continue;
            const std::uint32_t h = best->halfEdge;
            topology.creases[h] = topology.creases[topology.twins[h]] = true;
            for (const End& end : endsOf(mesh, topology, h)) count(end.point);
            sure.push_back(h);
        }
    }
}

void dropShortChains(const Mesh& mesh, std::uint32_t minEdges, MeshTopology& topology) {
    base::UnionFind groups{topology.pointCount};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.creases[h]) groups.unite(topology.points[h], topology.points[nextHalfEdge(h)]);
    std::vector<std::uint32_t> counts(topology.pointCount, 0);  // by root; each edge is two half-edges
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        if (topology.creases[h]) ++counts[groups.root(topology.points[h])];
        if (isHalfEdge(topology.twins[h]) && !isOfKind(mesh, h, topology.twins[h], EdgeKind::Sharp)) continue;
        for (const std::uint32_t c : {h, nextHalfEdge(h)}) counts[groups.root(topology.points[c])] += 2 * minEdges;
    }
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.creases[h] && counts[groups.root(topology.points[h])] < 2 * minEdges) topology.creases[h] = false;
}

}  // namespace inkedge::mesh

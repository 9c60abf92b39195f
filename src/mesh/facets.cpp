#include "mesh/facets.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace inkedge::mesh {
namespace {

// Below this share of split edges, of those that bend alike, the others are smooth: the author chose the split ones.
constexpr double maxChosenShare = 0.3;
// The share of split edges that chosen ones leave, at most, where they do not part regions.
constexpr double maxLooseShare = 0.1;

double lengthOf(const Mesh& mesh, std::uint32_t h) {
    return glm::distance(glm::dvec3{mesh.positions[mesh.indices[h]]},
                         glm::dvec3{mesh.positions[mesh.indices[nextHalfEdge(h)]]});
}

// Faces that hang together across edges which are not split.
base::UnionFind regionsOf(const MeshTopology& topology, std::span<const std::uint32_t> split) {
    std::vector<bool> isSplit(topology.twins.size(), false);
    for (const std::uint32_t h : split) isSplit[h] = isSplit[topology.twins[h]] = true;
    base::UnionFind regions{static_cast<std::uint32_t>(topology.originals.size())};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (isHalfEdge(twin) && !isSplit[h] && !topology.creases[h]) regions.unite(h / 3, twin / 3);
    }
    return regions;
}

struct Counts {
    double split = 0.0;   // lengths
    double shared = 0.0;  //
    double loose = 0.0;   // of split edges with one region on both sides
    std::size_t regions = 0;
    std::size_t links = 0;  // pairs of regions
};

bool isFaceted(const Counts& counts) {
    if (counts.split <= maxChosenShare * (counts.split + counts.shared)) return false;
    return counts.loose > maxLooseShare * counts.split || 4 * counts.links >= 3 * counts.regions;
}

template <class T>
void sortOnce(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

Facets::Facets(const Mesh& mesh, const MeshTopology& topology, const SplitEdges& edges)
    : components_{static_cast<std::uint32_t>(topology.originals.size())}, faceted_(topology.originals.size(), false) {
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (isHalfEdge(topology.twins[h])) components_.unite(h / 3, topology.twins[h] / 3);
    std::vector<Counts> counts(faceted_.size());
    const auto countsOf = [&](std::uint32_t face) -> Counts& { return counts[components_.root(face)]; };
    base::UnionFind regions = regionsOf(topology, edges.split);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
    for (const std::uint32_t h : edges.split) {
        const std::uint32_t a = regions.root(h / 3);
        const std::uint32_t b = regions.root(topology.twins[h] / 3);
        countsOf(a).split += lengthOf(mesh, h);
        if (a == b)
            countsOf(a).loose += lengthOf(mesh, h);
        else
            links.push_back(std::minmax(a, b));
    }
    for (const std::uint32_t h : edges.shared) countsOf(h / 3).shared += lengthOf(mesh, h);
    sortOnce(links);
    std::vector<std::uint32_t> linked;
    for (const auto& [a, b] : links) {
        ++countsOf(a).links;
        linked.insert(linked.end(), {a, b});
    }
    sortOnce(linked);
    for (const std::uint32_t region : linked) ++countsOf(region).regions;
    std::transform(counts.begin(), counts.end(), faceted_.begin(), isFaceted);
}

}  // namespace inkedge::mesh

#include "scene/seams.h"

#include <glm/common.hpp>

#include "mesh/topology.h"
#include "scene/box_tree.h"

namespace inkedge::scene {
namespace {

// Only very many unconnected faces that overlap each other need more steps. Seams that are then missed are drawn.
std::uint64_t stepsFor(std::size_t borders) { return 40'000'000 + 100 * std::uint64_t{borders}; }

std::vector<BorderEdge> collectBorders(
    const InstancedMeshes& instanced,
    const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals) {
    std::vector<BorderEdge> borders;
    for (std::uint32_t i = 0; i < instanced.instances.size(); ++i) {
        const Instance& instance = instanced.instances[i];
        const mesh::MeshTopology& topology = instanced.topologyOf(i);
        const std::vector<glm::dvec3>& normals = faceNormals(instance.mesh);
        for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
            if (topology.twins[h] != mesh::noHalfEdge || normals[h / 3] == glm::dvec3{0.0}) continue;
            if (topology.originals[h / 3] != h / 3) continue;  // a face that repeats another has no twins of its own
            if (const auto edge = borderEdgeOf(instanced, i, h)) borders.push_back(*edge);
        }
    }
    return borders;
}

std::vector<Box> boxesOf(const std::vector<BorderEdge>& edges) {
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const BorderEdge& edge : edges) boxes.push_back({glm::min(edge.a, edge.b), glm::max(edge.a, edge.b)});
    return boxes;
}

}  // namespace

Borders::Borders(const InstancedMeshes& instanced,
                 const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals)
    : edges_{collectBorders(instanced, faceNormals)},
      tolerance_{seamTolerance * instanced.bounds.radius},
      boxes_{boxesOf(edges_)},
      tree_{boxes_},
      stepsLeft_{stepsFor(edges_.size())} {}

void joinAcrossSeams(const InstancedMeshes& instanced, const std::vector<std::uint32_t>& base,
                     const LoadSettings& settings, base::UnionFind& joined) {
    Borders borders{instanced, [&](std::uint32_t mesh) -> const std::vector<glm::dvec3>& {
                        return instanced.topologies[mesh].faceNormals;
                    }};
    const SeamCreases creases{instanced, settings};
    std::vector<std::uint32_t> patches;
    patches.reserve(borders.edges().size());
    for (const BorderEdge& edge : borders.edges())
        patches.push_back(base[edge.instance] + instanced.topologyOf(edge.instance).patches[edge.halfEdge / 3]);
    for (std::uint32_t i = 0; i < borders.edges().size(); ++i) {
        const BorderEdge& border = borders.edges()[i];
        borders.forEachNear(i, [&](std::uint32_t j) {
            if (joined.root(patches[i]) == joined.root(patches[j])) return;
            const BorderEdge& other = borders.edges()[j];
            const auto shared = runAlong(border, other, borders.tolerance());
            if (shared && !creases.meetInCrease(border, other, *shared)) joined.unite(patches[i], patches[j]);
        });
    }
}

}  // namespace inkedge::scene

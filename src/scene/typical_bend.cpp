#include "scene/typical_bend.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/bends.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::scene {
namespace {

constexpr std::size_t maxSamples = 1U << 18U;  // half-edges of a scene
constexpr double flat = 0.05;                  // degrees: rounding bends faces by less

glm::dvec3 position(const Mesh& mesh, std::size_t corner) { return mesh.positions[mesh.indices[corner]]; }

glm::dvec3 faceNormal(const Mesh& mesh, std::size_t halfEdge) {
    const std::size_t first = halfEdge / 3 * 3;
    const glm::dvec3 a = position(mesh, first);
    return glm::cross(position(mesh, first + 1) - a, position(mesh, first + 2) - a);
}

double bendBetween(const glm::dvec3& one, const glm::dvec3& other) {
    // Faces may be wound against each other.
    const double angle = std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
    return glm::degrees(std::min(angle, glm::radians(180.0) - angle));
}

void collect(const Mesh& mesh, const mesh::MeshTopology& topology, std::size_t stride,
             std::vector<mesh::EdgeBend>& edges) {
    for (std::size_t h = 0; h < topology.twins.size(); h += stride) {
        const std::uint32_t twin = topology.twins[h];
        if (!mesh::isHalfEdge(twin) || topology.creases[h]) continue;
        if (mesh::isInner(mesh, static_cast<std::uint32_t>(h), twin)) continue;
        const double bend = bendBetween(faceNormal(mesh, h), faceNormal(mesh, twin));
        const double length =
            glm::distance(position(mesh, h), position(mesh, mesh::nextHalfEdge(static_cast<std::uint32_t>(h))));
        if (bend > flat && length > 0.0) edges.push_back({bend, length});
    }
}

}  // namespace

double typicalBend(const Scene& scene) {
    std::size_t all = 0;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) all += topologyOf(scene, i).twins.size();
    const std::size_t stride = mesh::strideOf(all, maxSamples);
    std::vector<mesh::EdgeBend> edges;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i)
        collect(scene.meshes()[i], topologyOf(scene, i), stride, edges);
    return mesh::medianOf(std::move(edges), 1.0);
}

}  // namespace inkedge::scene

#include "scene/seams.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/topology.h"
#include "scene/box_tree.h"
#include "scene/world_triangles.h"

namespace inkedge::scene {
namespace {

// Only very many unconnected faces that overlap each other need more steps. Seams that are then missed are drawn.
std::uint64_t maximumSteps(std::size_t borders) { return 40'000'000 + 100 * std::uint64_t{borders}; }

std::vector<BorderEdge> collectBorders(
    const InstancedMeshes& instanced,
    const std::function<const std::vector<glm::dvec3>&(std::uint32_t mesh)>& faceNormals) {
    std::vector<BorderEdge> borders;
    for (std::uint32_t i = 0; i < instanced.instances.size(); ++i) {
        const Instance& instance = instanced.instances[i];
        const mesh::MeshTopology& topology = instanced.topologyOf(i);
        const std::vector<glm::dvec3>& normals = faceNormals(instance.mesh);
        const WorldTriangles triangles{instanced.meshOf(i), instance.transform, instanced.bounds.centre};
        for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
            if (topology.twins[h] != mesh::noHalfEdge || normals[h / 3] == glm::dvec3{0.0}) continue;
            if (topology.originals[h / 3] != h / 3) continue;  // a face that repeats another has no twins of its own
            const glm::dvec3 a = triangles.corner(h);
            const glm::dvec3 b = triangles.corner(mesh::nextHalfEdge(h));
            const glm::dvec3 third = triangles.corner(mesh::previousHalfEdge(h));
            const double length = glm::length(b - a);
            if (length == 0.0) continue;
            const glm::dvec3 along = (b - a) / length;
            const glm::dvec3 across = third - a - along * glm::dot(third - a, along);
            if (glm::length(across) == 0.0) continue;
            borders.push_back({i, h, a, b, glm::normalize(across)});
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
      stepsLeft_{maximumSteps(edges_.size())} {}

std::optional<SharedLength> runAlong(const BorderEdge& one, const BorderEdge& other, double tolerance) {
    const double lengths[2]{glm::length(one.b - one.a), glm::length(other.b - other.a)};
    const bool swap = lengths[0] < lengths[1];
    const BorderEdge& longer = swap ? other : one;
    const BorderEdge& shorter = swap ? one : other;
    const double longLength = std::max(lengths[0], lengths[1]);
    const glm::dvec3 along = (longer.b - longer.a) / longLength;
    const auto distance = [&](glm::dvec3 p) { return glm::length(glm::cross(p - longer.a, along)); };
    if (distance(shorter.a) > tolerance || distance(shorter.b) > tolerance) return {};
    const double s = glm::dot(shorter.a - longer.a, along);
    const double e = glm::dot(shorter.b - longer.a, along);
    const double begin = std::max(std::min(s, e), 0.0);
    const double end = std::min(std::max(s, e), longLength);
    if (end - begin <= tolerance) return {};
    // The same stretch on the shorter segment, whose a lies at s and whose b lies at e.
    const double shares[2]{std::clamp((begin - s) / (e - s), 0.0, 1.0), std::clamp((end - s) / (e - s), 0.0, 1.0)};
    SharedLength shared{};
    shared.from[swap ? 1 : 0] = begin / longLength;
    shared.to[swap ? 1 : 0] = end / longLength;
    shared.from[swap ? 0 : 1] = std::min(shares[0], shares[1]);
    shared.to[swap ? 0 : 1] = std::max(shares[0], shares[1]);
    return shared;
}

void joinAcrossSeams(const InstancedMeshes& instanced, const std::vector<std::uint32_t>& base, double creaseAngle,
                     base::UnionFind& joined) {
    // The cosine between the `into` directions of two faces that bend by less than the crease angle is under this.
    const double oppositeCosine = -std::cos(glm::radians(creaseAngle));
    Borders borders{instanced, [&](std::uint32_t mesh) -> const std::vector<glm::dvec3>& {
                        return instanced.topologies[mesh].faceNormals;
                    }};
    const auto patchOf = [&](const BorderEdge& edge) {
        return base[edge.instance] + instanced.topologyOf(edge.instance).patches[edge.halfEdge / 3];
    };
    for (std::uint32_t i = 0; i < borders.edges().size(); ++i) {
        const BorderEdge& border = borders.edges()[i];
        borders.forEachNear(i, [&](std::uint32_t j) {
            const BorderEdge& other = borders.edges()[j];
            if (glm::dot(border.into, other.into) > oppositeCosine) return;
            if (joined.root(patchOf(border)) == joined.root(patchOf(other))) return;
            if (runAlong(border, other, borders.tolerance())) joined.unite(patchOf(border), patchOf(other));
        });
    }
}

}  // namespace inkedge::scene

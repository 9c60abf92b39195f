#include "scene/normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/union_find.h"

namespace inkedge {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr glm::vec3 anyNormal{0.0F, 0.0F, 1.0F};  // of a face without area: it is never drawn

glm::dvec3 unitOrZero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3{0.0};
}

glm::dvec3 position(const Mesh& mesh, std::uint32_t corner) { return {mesh.positions[mesh.indices[corner]]}; }

double cornerAngle(const Mesh& mesh, std::uint32_t corner) {
    const std::uint32_t next = nextHalfEdge(corner);
    const glm::dvec3 p = position(mesh, corner);
    const glm::dvec3 a = unitOrZero(position(mesh, next) - p);
    const glm::dvec3 b = unitOrZero(position(mesh, nextHalfEdge(next)) - p);
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

// For every corner the corner that stands for all that share its normal.
Corners smoothingGroups(const Mesh& mesh, const MeshTopology& topology, double creaseAngle) {
    const double smoothCosine = std::cos(glm::radians(creaseAngle));
    UnionFind groups{static_cast<std::uint32_t>(topology.points.size())};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        // Faces wound against each other have normals to opposite sides: they cannot share one.
        if (!isHalfEdge(twin) || twin < h || topology.points[h] == topology.points[twin]) continue;
        if (bendCosine(topology, h, twin) < smoothCosine && !isInner(mesh, h, twin)) continue;
        groups.unite(h, nextHalfEdge(twin));
        groups.unite(nextHalfEdge(h), twin);
    }
    Corners roots(topology.points.size());
    for (std::uint32_t c = 0; c < roots.size(); ++c) roots[c] = groups.root(c);
    return roots;
}

std::vector<glm::vec3> groupNormals(const Mesh& mesh, const std::vector<glm::dvec3>& faces, const Corners& groups) {
    std::vector<glm::dvec3> sums(groups.size(), glm::dvec3{0.0});
    for (std::uint32_t c = 0; c < groups.size(); ++c) sums[groups[c]] += cornerAngle(mesh, c) * faces[c / 3];
    std::vector<glm::vec3> normals(groups.size());
    for (std::uint32_t c = 0; c < groups.size(); ++c) {
        const glm::dvec3 unit = unitOrZero(sums[groups[c]]);
        normals[c] = unit == glm::dvec3{0.0} ? anyNormal : glm::vec3{unit};
    }
    return normals;
}

// Rewrites the mesh so that a vertex is one position with one normal.
void splitVertices(Mesh& mesh, const std::vector<bool>& wanted, const std::vector<glm::vec3>& made,
                   const Corners& groups) {
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> vertexOfGroup(groups.size(), none);
    std::vector<std::uint32_t> keptVertex(mesh.positions.size(), none);
    Mesh split;
    const auto add = [&](glm::vec3 p, glm::vec3 n) {
        split.positions.push_back(p);
        split.normals.push_back(n);
        return static_cast<std::uint32_t>(split.positions.size() - 1);
    };
    for (std::uint32_t c = 0; c < groups.size(); ++c) {
        const std::uint32_t vertex = mesh.indices[c];
        std::uint32_t& to = wanted[vertex] ? vertexOfGroup[groups[c]] : keptVertex[vertex];
        if (to == none) to = add(mesh.positions[vertex], wanted[vertex] ? made[c] : mesh.normals[vertex]);
        split.indices.push_back(to);
    }
    mesh.positions = std::move(split.positions);
    mesh.normals = std::move(split.normals);
    mesh.indices = std::move(split.indices);
}

void windByNormals(Mesh& mesh) {
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const auto face = mesh.indices.begin() + static_cast<std::ptrdiff_t>(t);
        const glm::dvec3 a{mesh.positions[face[0]]};
        const glm::dvec3 area =
            glm::cross(glm::dvec3{mesh.positions[face[1]]} - a, glm::dvec3{mesh.positions[face[2]]} - a);
        const glm::dvec3 normals{mesh.normals[face[0]] + mesh.normals[face[1]] + mesh.normals[face[2]]};
        if (glm::dot(area, normals) < 0.0) turnOver(mesh, t);
    }
}

}  // namespace

void applyAuthoredNormals(Mesh& mesh, const LoadSettings& settings) {
    if (settings.normals == Normals::Flat) mesh.normals.clear();
    mesh.normals.resize(mesh.positions.size(), glm::vec3{0.0F});
    for (glm::vec3& normal : mesh.normals) {
        if (!std::isfinite(glm::dot(normal, normal))) normal = glm::vec3{0.0F};
    }
    windByNormals(mesh);
}

void completeNormals(Mesh& mesh, const MeshTopology& topology, const LoadSettings& settings) {
    std::vector<bool> wanted(mesh.positions.size());
    std::transform(mesh.normals.begin(), mesh.normals.end(), wanted.begin(),
                   [](glm::vec3 n) { return n == glm::vec3{0.0F}; });
    if (std::ranges::find(wanted, true) == wanted.end()) return;

    Corners groups(mesh.indices.size());
    std::iota(groups.begin(), groups.end(), 0U);
    if (settings.normals == Normals::Auto) groups = smoothingGroups(mesh, topology, settings.creaseAngle);
    splitVertices(mesh, wanted, groupNormals(mesh, topology.faceNormals, groups), groups);
}

}  // namespace inkedge

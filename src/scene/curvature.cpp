#include "scene/curvature.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace inkedge {
namespace {

glm::dvec3 cornerOf(const Mesh& mesh, std::uint32_t corner) { return glm::dvec3{mesh.positions[mesh.indices[corner]]}; }

// By how much the faces turn across an edge, radians, over 0 where they bulge.
double bend(const Mesh& mesh, const MeshTopology& topology, const std::vector<glm::dvec3>& normals,
            std::uint32_t halfEdge, std::uint32_t twin) {
    const glm::dvec3 along = cornerOf(mesh, nextHalfEdge(halfEdge)) - cornerOf(mesh, halfEdge);
    const double length = glm::length(along);
    if (length == 0.0) return 0.0;
    const glm::dvec3& one = normals[halfEdge / 3];
    const bool woundAgainst = topology.points[halfEdge] == topology.points[twin];
    const glm::dvec3 other = woundAgainst ? -normals[twin / 3] : normals[twin / 3];
    return std::atan2(glm::dot(glm::cross(one, other), along) / length, glm::dot(one, other));
}

}  // namespace

std::vector<float> meanCurvatures(const Mesh& mesh, const MeshTopology& topology) {
    std::vector<double> bends(topology.pointCount, 0.0);
    std::vector<double> areas(topology.pointCount, 0.0);
    const std::vector<glm::dvec3> normals = makeFaceNormals(mesh);
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const std::uint32_t next = nextHalfEdge(h);
        const glm::dvec3 along = cornerOf(mesh, next) - cornerOf(mesh, h);
        const glm::dvec3 across = cornerOf(mesh, nextHalfEdge(next)) - cornerOf(mesh, h);
        areas[topology.points[h]] += glm::length(glm::cross(along, across)) / 6.0;
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin)) continue;
        // A quarter of length times angle for each end: half for the mean of two curvatures, half for the two ends. The
        // twin adds the same once more.
        const double share = 0.125 * glm::length(along) * bend(mesh, topology, normals, h, twin);
        bends[topology.points[h]] += share;
        bends[topology.points[next]] += share;
    }
    std::vector<float> curvatures(mesh.positions.size(), 0.0F);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const std::uint32_t point = topology.points[c];
        if (areas[point] > 0.0) curvatures[mesh.indices[c]] = static_cast<float>(bends[point] / areas[point]);
    }
    return curvatures;
}

}  // namespace inkedge

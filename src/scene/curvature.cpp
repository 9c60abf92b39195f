#include "scene/curvature.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
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

// What is said of each point: how much the surface bends there, and how much of it lies there.
struct Point {
    double bend = 0.0;
    double area = 0.0;
    friend Point operator+(Point a, Point b) { return {a.bend + b.bend, a.area + b.area}; }
    friend Point operator*(double factor, Point p) { return {factor * p.bend, factor * p.area}; }
};

// How often spread() makes a Gaussian of leastDetail.
int stepsFor(const Mesh& mesh) {
    constexpr double leastDetail = 0.008;  // of the mesh's extent: what is smaller is roughness
    constexpr int most = 32;
    Box box{glm::dvec3{mesh.positions[mesh.indices[0]]}, glm::dvec3{mesh.positions[mesh.indices[0]]}};
    double length = 0.0;
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const glm::dvec3 place = cornerOf(mesh, h);
        box = {glm::min(box.min, place), glm::max(box.max, place)};
        length += glm::distance(place, cornerOf(mesh, nextHalfEdge(h)));
    }
    length /= static_cast<double>(mesh.indices.size());
    if (length == 0.0) return 0;
    // A step moves half of a point's share by an edge: by a quarter of its length's square along each axis.
    const double ratio = leastDetail * glm::distance(box.min, box.max) / length;
    return static_cast<int>(std::min(4.0 * ratio * ratio, static_cast<double>(most)));
}

// Half of what a point has goes to its neighbours, evenly; the sums over the mesh stay.
void spread(const MeshTopology& topology, const std::vector<double>& neighbours, std::vector<Point>& points) {
    std::vector<Point> moved(points.size());
    for (std::uint32_t h = 0; h < topology.points.size(); ++h) {
        const std::uint32_t from = topology.points[h];
        const std::uint32_t to = topology.points[nextHalfEdge(h)];
        moved[to] = moved[to] + (0.5 / neighbours[from]) * points[from];
        moved[from] = moved[from] + (0.5 / neighbours[to]) * points[to];
    }
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = 0.5 * points[i] + moved[i];
}

// Counted once for each triangle at an edge.
std::vector<double> countNeighbours(const MeshTopology& topology) {
    std::vector<double> neighbours(topology.pointCount, 0.0);
    for (std::uint32_t h = 0; h < topology.points.size(); ++h) {
        neighbours[topology.points[h]] += 1.0;
        neighbours[topology.points[nextHalfEdge(h)]] += 1.0;
    }
    return neighbours;
}

}  // namespace

std::vector<float> meanCurvatures(const Mesh& mesh, const MeshTopology& topology) {
    std::vector<Point> points(topology.pointCount);
    const std::vector<glm::dvec3> normals = makeFaceNormals(mesh);
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const std::uint32_t next = nextHalfEdge(h);
        const glm::dvec3 along = cornerOf(mesh, next) - cornerOf(mesh, h);
        const glm::dvec3 across = cornerOf(mesh, nextHalfEdge(next)) - cornerOf(mesh, h);
        points[topology.points[h]].area += glm::length(glm::cross(along, across)) / 6.0;
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin)) continue;
        // A quarter of length times angle for each end: half for the mean of two curvatures, half for the two ends. The
        // twin adds the same once more.
        const double share = 0.125 * glm::length(along) * bend(mesh, topology, normals, h, twin);
        points[topology.points[h]].bend += share;
        points[topology.points[next]].bend += share;
    }
    const std::vector<double> neighbours = countNeighbours(topology);
    for (int step = stepsFor(mesh); step > 0; --step) spread(topology, neighbours, points);
    std::vector<float> curvatures(mesh.positions.size(), 0.0F);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const auto& [bend, area] = points[topology.points[c]];
        if (area > 0.0) curvatures[mesh.indices[c]] = static_cast<float>(bend / area);
    }
    return curvatures;
}

}  // namespace inkedge

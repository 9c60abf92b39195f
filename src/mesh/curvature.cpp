#include "mesh/curvature.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/fans.h"

namespace inkedge::mesh {
namespace {

glm::dvec3 cornerOf(const Mesh& mesh, std::uint32_t corner) { return glm::dvec3{mesh.positions[mesh.indices[corner]]}; }

// The angle between the normals of the faces at an edge, radians, over 0 where the surface bulges.
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

// How much the surface bends around a point, and how much of the surface's area belongs to the point.
struct Share {
    double bend = 0.0;
    double area = 0.0;
    friend Share operator+(Share a, Share b) { return {a.bend + b.bend, a.area + b.area}; }
    friend Share operator*(double factor, Share p) { return {factor * p.bend, factor * p.area}; }
};

// One share per fan, at the index of the fan.
std::vector<Share> measure(const Mesh& mesh, const MeshTopology& topology, const std::vector<std::uint32_t>& fans) {
    std::vector<Share> shares(fans.size());
    const std::vector<glm::dvec3> normals = makeFaceNormals(mesh, topology);
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const std::uint32_t next = nextHalfEdge(h);
        const glm::dvec3 along = cornerOf(mesh, next) - cornerOf(mesh, h);
        const glm::dvec3 across = cornerOf(mesh, nextHalfEdge(next)) - cornerOf(mesh, h);
        shares[fans[h]].area += glm::length(glm::cross(along, across)) / 6.0;
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin) || topology.creases[h]) continue;
        // Each end gets a quarter of length times angle: the mean of two curvatures halves it, and so do the two ends.
        // The twin adds the same once more, hence an eighth.
        const double share = 0.125 * glm::length(along) * bend(mesh, topology, normals, h, twin);
        shares[fans[h]].bend += share;
        shares[fans[next]].bend += share;
    }
    return shares;
}

// How many steps of spread() make a Gaussian of minDetail.
int stepsFor(const Mesh& mesh) {
    constexpr double minDetail = 0.008;  // of the mesh's extent: what is smaller is roughness
    constexpr int maxSteps = 32;
    Box box{cornerOf(mesh, 0), cornerOf(mesh, 0)};
    double length = 0.0;
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
        const glm::dvec3 position = cornerOf(mesh, h);
        box = {glm::min(box.min, position), glm::max(box.max, position)};
        length += glm::distance(position, cornerOf(mesh, nextHalfEdge(h)));
    }
    length /= static_cast<double>(mesh.indices.size());
    if (length == 0.0) return 0;
    // A step moves half of a point's share by the length of an edge: its variance along each axis is a quarter of the
    // length's square.
    const double ratio = minDetail * glm::distance(box.min, box.max) / length;
    return static_cast<int>(std::min(4.0 * ratio * ratio, static_cast<double>(maxSteps)));
}

// Half of each fan's share goes to the fans at the other ends of its edges, evenly. The sums over the mesh stay.
void spread(const std::vector<std::uint32_t>& fans, const std::vector<double>& edges, std::vector<Share>& shares) {
    std::vector<Share> moved(shares.size());
    for (std::uint32_t h = 0; h < fans.size(); ++h) {
        const std::uint32_t from = fans[h];
        const std::uint32_t to = fans[nextHalfEdge(h)];
        moved[to] = moved[to] + (0.5 / edges[from]) * shares[from];
        moved[from] = moved[from] + (0.5 / edges[to]) * shares[to];
    }
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = 0.5 * shares[i] + moved[i];
}

// The number of edges of each fan, counted once for each triangle at an edge.
std::vector<double> countEdges(const std::vector<std::uint32_t>& fans) {
    std::vector<double> edges(fans.size(), 0.0);
    for (std::uint32_t h = 0; h < fans.size(); ++h) {
        edges[fans[h]] += 1.0;
        edges[fans[nextHalfEdge(h)]] += 1.0;
    }
    return edges;
}

}  // namespace

std::vector<float> meanCurvatures(const Mesh& mesh, const MeshTopology& topology) {
    if (mesh.indices.empty()) return std::vector<float>(mesh.positions.size(), 0.0F);
    const std::vector<std::uint32_t> fans = findFans(topology);
    std::vector<Share> shares = measure(mesh, topology, fans);
    const std::vector<double> edges = countEdges(fans);
    for (int step = stepsFor(mesh); step > 0; --step) spread(fans, edges, shares);
    // A position that belongs to several fans has the mean of their curvatures.
    std::vector<Share> all(mesh.positions.size());
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) all[mesh.indices[c]] = all[mesh.indices[c]] + shares[fans[c]];
    std::vector<float> curvatures(mesh.positions.size(), 0.0F);
    std::ranges::transform(all, curvatures.begin(), [](const Share& share) {
        return share.area > 0.0 ? static_cast<float>(share.bend / share.area) : 0.0F;
    });
    return curvatures;
}

}  // namespace inkedge::mesh

#include "scene/border_edge.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/authored_normals.h"
#include "mesh/creases.h"
#include "mesh/topology.h"
#include "scene/world_triangles.h"

namespace inkedge::scene {

std::optional<BorderEdge> borderEdgeOf(const InstancedMeshes& instanced, std::uint32_t instance,
                                       std::uint32_t halfEdge) {
    const WorldTriangles triangles{instanced.meshOf(instance), instanced.instances[instance].transform,
                                   instanced.bounds.centre};
    const glm::dvec3 a = triangles.corner(halfEdge);
    const glm::dvec3 b = triangles.corner(mesh::nextHalfEdge(halfEdge));
    const glm::dvec3 third = triangles.corner(mesh::previousHalfEdge(halfEdge));
    const double length = glm::length(b - a);
    if (length == 0.0) return {};
    const glm::dvec3 along = (b - a) / length;
    const glm::dvec3 across = third - a - along * glm::dot(third - a, along);
    if (glm::length(across) == 0.0) return {};
    return BorderEdge{instance, halfEdge, a, b, glm::normalize(across)};
}

std::optional<SharedLength> runAlong(const BorderEdge& one, const BorderEdge& other, double tolerance) {
    const glm::dvec3 ways[2]{one.b - one.a, other.b - other.a};
    const double squares[2]{glm::dot(ways[0], ways[0]), glm::dot(ways[1], ways[1])};
    const bool swap = squares[0] < squares[1];
    const BorderEdge& longer = swap ? other : one;
    const BorderEdge& shorter = swap ? one : other;
    const glm::dvec3& way = ways[swap ? 1 : 0];
    // Squares, as most pairs end here: the area of the parallelogram with p is its distance times the length.
    const double limit = tolerance * tolerance * std::max(squares[0], squares[1]);
    const auto isFar = [&](glm::dvec3 p) {
        const glm::dvec3 area = glm::cross(p - longer.a, way);
        return glm::dot(area, area) > limit;
    };
    if (isFar(shorter.a) || isFar(shorter.b)) return {};
    const double longLength = glm::length(way);
    const glm::dvec3 along = way / longLength;
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

SeamCreases::SeamCreases(const InstancedMeshes& instanced, const LoadSettings& settings)
    : instanced_{instanced},
      creaseCosine_{-std::cos(glm::radians(settings.creaseAngle))},
      sharedCosine_{-std::cos(glm::radians(mesh::sharedCreaseAngle(settings)))} {}

bool SeamCreases::meetInCrease(const BorderEdge& one, const BorderEdge& other, const SharedLength& shared) const {
    const double cosine = glm::dot(one.into, other.into);
    return cosine > creaseCosine_ && (cosine > sharedCosine_ || !haveOneNormal(one, other, shared));
}

bool SeamCreases::haveOneNormal(const BorderEdge& one, const BorderEdge& other, const SharedLength& shared) const {
    const auto isMirrored = [&](const BorderEdge& edge) {
        return glm::determinant(glm::dmat3{instanced_.instances[edge.instance].transform}) < 0.0;
    };
    const bool alike = glm::dot(one.b - one.a, other.b - other.a) > 0.0;
    // Normals of faces wound against each other may point to opposite sides of one surface.
    const double side = alike == (isMirrored(one) == isMirrored(other)) ? -1.0 : 1.0;
    const auto agree = [&](double share, double otherShare) {
        return side * glm::dot(normalAt(one, share), normalAt(other, otherShare)) >= std::cos(mesh::sameNormal);
    };
    return agree(shared.from[0], alike ? shared.from[1] : shared.to[1]) &&
           agree(shared.to[0], alike ? shared.to[1] : shared.from[1]);
}

glm::dvec3 SeamCreases::normalAt(const BorderEdge& edge, double share) const {
    const Mesh& mesh = instanced_.meshOf(edge.instance);
    const auto normal = [&](std::uint32_t corner) { return glm::dvec3{mesh.normals[mesh.indices[corner]]}; };
    const glm::dvec3 between = glm::mix(normal(edge.halfEdge), normal(mesh::nextHalfEdge(edge.halfEdge)), share);
    const glm::dmat3 transform{instanced_.instances[edge.instance].transform};
    const glm::dvec3 inWorld = glm::inverseTranspose(transform) * between;
    const double length = glm::length(inWorld);
    return length > 0.0 && std::isfinite(length) ? inWorld / length : glm::dvec3{0.0};
}

}  // namespace inkedge::scene

#include "mesh/distort.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/message.h"
#include "mesh/topology.h"

namespace inkedge::mesh {
namespace {

constexpr double angleTolerance = 1e-5;  // the error of rotations and even scales stored as floats

bool finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

glm::vec3 transformedNormal(const glm::dmat3& cofactors, glm::vec3 normal) {
    const glm::dvec3 n = cofactors * glm::dvec3{normal};
    const double length = glm::length(n);
    return length > 0.0 ? glm::vec3{n / length} : glm::vec3{0.0F};
}

}  // namespace

bool keepsAngles(const glm::dmat3& m) {
    const double scale = glm::dot(m[0], m[0]);
    const double slack = angleTolerance * scale;
    return std::abs(glm::dot(m[1], m[1]) - scale) <= slack && std::abs(glm::dot(m[2], m[2]) - scale) <= slack &&
           std::abs(glm::dot(m[0], m[1])) <= slack && std::abs(glm::dot(m[1], m[2])) <= slack &&
           std::abs(glm::dot(m[2], m[0])) <= slack;
}

Mesh distorted(const Mesh& mesh, const glm::dmat3& m) {
    Mesh result = mesh;
    result.surfaces = nullptr;  // they are not distorted
    result.parameters.clear();
    result.limitTriangles.clear();
    result.origin = m * mesh.origin;
    for (glm::vec3& p : result.positions) p = glm::vec3{m * glm::dvec3{p}};
    for (glm::vec3& p : result.lines) p = glm::vec3{m * glm::dvec3{p}};
    if (!std::ranges::all_of(result.positions, finite) || !std::ranges::all_of(result.lines, finite) ||
        !finite(glm::vec3{result.origin}))
        base::refuse("mesh " + base::quote(mesh.name) +
                     ": expected finite positions, found a transform that takes them out of range");
    // The inverse transpose but for its scale; it also exists where the distortion flattens the mesh.
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors{sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]),
                               sign * glm::cross(m[0], m[1])};
    for (glm::vec3& n : result.normals) n = transformedNormal(cofactors, n);
    if (sign < 0.0) {  // mirrored: normals made later shall still point to the front
        for (std::size_t t = 0; t + 2 < result.indices.size(); t += 3) turnOver(result, t);
    }
    return result;
}

}  // namespace inkedge::mesh

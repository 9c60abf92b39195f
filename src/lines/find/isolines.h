#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge {

/// Where a texture coordinate passes one of its steps on a face.
struct IsolineSegment {
    std::uint32_t triangle = 0;          ///< of the mesh
    std::uint32_t coordinate = 0;        ///< 0: u, 1: v
    std::int32_t step = 0;               ///< the coordinate there times the steps
    std::array<glm::dvec3, 2> ends;      ///< mesh space less Mesh::origin
    std::array<glm::dvec3, 2> weights;   ///< of the triangle's corners, likewise: barycentric coordinates
    std::array<std::uint32_t, 2> nodes;  ///< one an end: segments that share a number go on into each other there;
                                         ///< 0, 1, 2, ... with no number left out
};

/// A face that a coordinate passes more steps of than this gives no lines: they would be an even grey.
inline constexpr double mostStepsAcrossAFace = 1000.0;

/// The lines along which u is a multiple of 1 / steps.u, and v of 1 / steps.v, where the coordinate is linear across
/// each face. They lie on faces, from edge to edge; a line that follows an edge is one segment, whatever faces share
/// it, and a face in which the coordinate is the same everywhere has none. Lines go on across a seam where both sides
/// have the same value at the same place. Repeated faces and those with two corners at one point take no part.
///
/// Ordered by triangle, coordinate and step. A mesh without texture coordinates has none. Pure, thread-safe,
/// O(n log n).
[[nodiscard]] std::vector<IsolineSegment> findIsolines(const Mesh&, const MeshTopology&, Isolines steps);

}  // namespace inkedge

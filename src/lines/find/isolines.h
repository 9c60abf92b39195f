#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge::lines {

/// A segment of a face along which a texture coordinate has the value of one of its steps.
struct IsolineSegment {
    std::uint32_t triangle = 0;         ///< of the mesh
    std::uint32_t coordinate = 0;       ///< 0: u, 1: v
    std::int32_t step = 0;              ///< the coordinate there times the steps
    std::array<glm::dvec3, 2> ends;     ///< mesh space less Mesh::origin
    std::array<glm::dvec3, 2> weights;  ///< the ends in barycentric coordinates of the triangle
    /// One per end: segments with the same number are joined there. 0, 1, 2, ... with no number left out.
    std::array<std::uint32_t, 2> nodes;
};

/// A face across which a coordinate passes more steps than this has no lines: they would be an even grey.
inline constexpr double maxStepsPerFace = 1000.0;

/// The lines along which u is a multiple of 1 / steps.u, and v of 1 / steps.v. Coordinates are linear across each face.
/// Segments lie on faces, from edge to edge. A line that follows an edge is one segment, however many faces share the
/// edge. A face with the same coordinate everywhere has no line. Lines go on across a seam where both sides have the
/// same value at the same position. Repeated faces, and faces with two corners at one point, are left out.
///
/// Ordered by triangle, coordinate and step. A mesh without texture coordinates has none. Pure, thread-safe,
/// O(n log n).
[[nodiscard]] std::vector<IsolineSegment> findIsolines(const Mesh&, const mesh::MeshTopology&, Isolines steps);

}  // namespace inkedge::lines

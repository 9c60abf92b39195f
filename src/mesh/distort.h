#pragma once

#include <glm/mat3x3.hpp>

#include <inkedge/mesh.h>

namespace inkedge::mesh {

/// Whether a linear map keeps angles, within the rounding of floats: it rotates, mirrors and scales evenly.
[[nodiscard]] bool keepsAngles(const glm::dmat3&);

/// A mesh with a linear map applied to its vertices. If the map mirrors, the triangles are turned over, so that normals
/// made later still point to the front.
/// @throws Error  (Kind::Input) if it takes positions out of the range of floats
[[nodiscard]] Mesh distorted(const Mesh&, const glm::dmat3&);

}  // namespace inkedge::mesh

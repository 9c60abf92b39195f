#pragma once

#include <glm/mat3x3.hpp>

#include <inkedge/mesh.h>

namespace inkedge {

/// Whether a linear map keeps angles: it turns, mirrors and scales evenly, to what floats are off by.
[[nodiscard]] bool keepsAngles(const glm::dmat3&);

/// A mesh with a linear map in its vertices. Where the map mirrors, the triangles are turned over: their front stays
/// the front for normals that are yet to be made.
/// @throws Error  (Kind::Input) if it takes positions out of the range of floats
[[nodiscard]] Mesh distorted(const Mesh&, const glm::dmat3&);

}  // namespace inkedge

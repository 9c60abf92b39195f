#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

namespace inkedge::mesh {

/// Drops the vertices that no triangle uses. Meshes of a file may share one vertex array and use a part of it each;
/// what is not drawn must not count for the bounds.
void dropUnusedVertices(Mesh&);

/// Moves some triangles before all others; both groups keep their order.
/// @param first  one per triangle: whether to move it
void bringForward(Mesh&, const std::vector<bool>& first);

}  // namespace inkedge::mesh

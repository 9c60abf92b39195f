#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

namespace inkedge::mesh {

/// Brings the vertices into the order in which triangles use them, so that what lies side by side in memory is used
/// together, and drops those that no triangle uses. Meshes of a file may share one vertex array and use a part of it
/// each; what is not drawn must not count for the bounds. O(n).
void arrangeVertices(Mesh&);

/// Brings the triangles of a large mesh into Z order if those that follow each other lie far apart, as in files of
/// which some tool wrote the triangles at random. Not if the mesh says anything of its edges or faces. O(n).
void arrangeTriangles(Mesh&);

/// Moves some triangles before all others; both groups keep their order.
/// @param first  one per triangle: whether to move it
void bringForward(Mesh&, const std::vector<bool>& first);

}  // namespace inkedge::mesh

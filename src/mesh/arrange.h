#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

namespace inkedge {

/// Drops the vertices that no triangle has. Parts of a file may share one vertex array and use a part of it each; what
/// is not drawn must not count for the bounds.
void dropUnusedVertices(Mesh&);

/// Brings some triangles before all others; both keep their order.
/// @param first  one a triangle
void bringForward(Mesh&, const std::vector<bool>& first);

}  // namespace inkedge

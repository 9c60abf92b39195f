#pragma once

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Finds out how the faces of a mesh are connected, and gives every vertex a normal if that is asked for: whether the
/// file's normals deserve belief, which way faces are wound, which edges are creases, the normals that are missing, the
/// patches.
/// @return  complete. O(n).
[[nodiscard]] MeshTopology connect(Mesh&, const LoadSettings&);

}  // namespace inkedge::mesh

#pragma once

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// The median of the bends at the edges of two faces, weighted by the edges' lengths; degrees, to one. Of large meshes
/// only a sample of the edges is looked at.
[[nodiscard]] double medianBend(const Mesh&, const MeshTopology&);

}  // namespace inkedge::mesh

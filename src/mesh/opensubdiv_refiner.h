#pragma once

#include <memory>

#include <opensubdiv/far/topologyRefiner.h>

#include "mesh/control_mesh.h"

namespace inkedge::mesh {

using Refiner = std::unique_ptr<OpenSubdiv::Far::TopologyRefiner>;

/// OpenSubdiv's form of a control mesh, not refined yet.
/// @throws std::runtime_error  if OpenSubdiv refuses it
[[nodiscard]] Refiner makeRefiner(const ControlMesh&);

}  // namespace inkedge::mesh

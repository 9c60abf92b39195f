#pragma once

#include <memory>

#include "mesh/control_mesh.h"
#include "mesh/subdivision.h"

namespace inkedge::mesh {

/// The limit surface of a control mesh. It is exact but for what lies within a 1024th of a face's side of a point where
/// other than the usual number of faces meet, which is approximate (Loop et al. 2009).
/// @throws std::runtime_error  if OpenSubdiv refuses the control mesh
[[nodiscard]] std::shared_ptr<const LimitSurface> limitSurface(const ControlMesh&);

}  // namespace inkedge::mesh

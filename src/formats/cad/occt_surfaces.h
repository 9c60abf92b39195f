#pragma once

#include <TopoDS_Face.hxx>

#include "formats/cad/surface_data.h"

namespace inkedge::cad {

/// The surface of a face by its numbers. SurfaceKind::None: it is of a kind that has none here, swept along a hyperbola
/// say.
[[nodiscard]] SurfaceData surfaceOf(const TopoDS_Face&);

}  // namespace inkedge::cad

#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "formats/cad/surface_data.h"
#include "mesh/surface_point.h"

namespace inkedge::cad {

/// A point of a curve, with its first two derivatives.
using CurvePoint = std::array<glm::dvec3, 3>;

/// Beyond its knots the curve goes on as its last piece does, a periodic one as it is at the other end. O(degree^2).
[[nodiscard]] CurvePoint nurbsAt(const CurveData&, double t);
[[nodiscard]] mesh::SurfaceDerivatives nurbsAt(const SurfaceData&, glm::dvec2 uv);

}  // namespace inkedge::cad

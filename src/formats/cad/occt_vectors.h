#pragma once

#include <gp_XYZ.hxx>

#include <glm/vec3.hpp>

namespace inkedge::cad {

[[nodiscard]] inline glm::dvec3 vectorOf(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

}  // namespace inkedge::cad

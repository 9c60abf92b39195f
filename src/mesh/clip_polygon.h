#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/polygon_triangles.h"

namespace inkedge::mesh {

/// The part of a polygon within a box; of a concave one with edges along the box where it comes in again.
[[nodiscard]] Polygon withinBox(Polygon, glm::dvec2 low, glm::dvec2 high);

inline constexpr std::size_t longOutline = 256;

/// What of a long outline lies about a polygon: it is cut off beyond the polygon's box, so that cutting along it takes
/// as long as what lies there. A short one, or one about as large as the polygon, comes back as it is.
/// @param outline  longOutline corners or fewer are a short one
[[nodiscard]] std::vector<Polygon> beside(const Polygon& polygon, std::span<const Polygon> outline);

}  // namespace inkedge::mesh

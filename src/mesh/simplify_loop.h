#pragma once

#include <vector>

#include "mesh/polygon_triangles.h"

namespace inkedge::mesh {

/// A loop with fewer corners, none of which moves: Douglas and Peucker, between the corners that stay.
/// @param fixed      one per corner: whether it stays
/// @param tolerance  how far the loop may move, in its unit
[[nodiscard]] Polygon simplified(const Polygon& loop, const std::vector<bool>& fixed, double tolerance);

}  // namespace inkedge::mesh

#pragma once

#include <vector>

#include <inkedge/lines.h>

#include "lines/screen.h"

namespace inkedge::lines {

/// Joins lines of one type, visibility and node whose ends lie within widestBridge of each other in the picture and
/// nearly so in space, and that go on into each other with a bend of under 45 degrees; the nearest ends first. A line
/// whose own ends do so becomes closed. O(n log n).
/// @param origin  what Screen's world is less
[[nodiscard]] std::vector<Line> bridgeGaps(std::vector<Line>, const Screen&, glm::dvec3 origin);

inline constexpr double widestBridge = 1.5;  ///< pixels

}  // namespace inkedge::lines

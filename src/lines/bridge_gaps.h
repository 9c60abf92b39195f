#pragma once

#include <vector>

#include <inkedge/lines.h>

#include "lines/screen.h"

namespace inkedge::lines {

/// Joins lines of one type, visibility and node that go on into each other: their ends lie within maxBridge of each
/// other in the picture and about as near in space, and they bend by under 45 degrees. The nearest ends are joined
/// first. A line whose own two ends do so becomes closed. O(n log n).
/// @param origin  the origin of the screen's world space
[[nodiscard]] std::vector<Line> bridgeGaps(std::vector<Line>, const Screen&, glm::dvec3 origin);

inline constexpr double maxBridge = 1.5;  ///< pixels

}  // namespace inkedge::lines

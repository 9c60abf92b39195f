#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge::curves {

/// The parts of a line that lie in a rectangle, its sides included, in their order along the line. A closed line that
/// lies wholly in the rectangle stays closed. Where an edge is cut the world position is interpolated by the share of
/// the edge in the picture: near the true position, but not exact in perspective. Pure, thread-safe, O(n).
[[nodiscard]] std::vector<Line> clip(const Line&, glm::dvec2 low, glm::dvec2 high);

}  // namespace inkedge::curves

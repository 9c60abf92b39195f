#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge {

/// The parts of a line that lie in a rectangle, its sides included, in their order along the line. A closed line that
/// lies in it wholly stays closed. World points of the ends that are cut are those of the ends' shares of their edges
/// in the picture: near, but not exact in perspective. Pure, thread-safe, O(n).
[[nodiscard]] std::vector<Line> clip(const Line&, glm::dvec2 low, glm::dvec2 high);

}  // namespace inkedge

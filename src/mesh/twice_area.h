#pragma once

#include <glm/vec2.hpp>

namespace inkedge::mesh {

/// Twice the area of a triangle, over 0 if it runs anticlockwise (x to the right, y up).
[[nodiscard]] inline double twiceArea(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) noexcept {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace inkedge::mesh

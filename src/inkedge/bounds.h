#pragma once

#include <glm/vec3.hpp>

namespace inkedge {

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// Axis-aligned box; empty while min > max.
struct Box {
    glm::dvec3 min{1.0};
    glm::dvec3 max{-1.0};
    [[nodiscard]] bool empty() const noexcept { return min.x > max.x; }
};

}  // namespace inkedge

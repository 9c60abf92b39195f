#pragma once

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

namespace inkedge {

/// The largest dot product of a direction with any drawn vertex, in world space. Instances whose box cannot reach
/// further than what is already found are not looked into.
[[nodiscard]] double support(const Scene&, glm::dvec3 direction);

/// The box of all drawn vertices, in world space.
[[nodiscard]] Box boxOfAll(const Scene&);

/// The distance of the drawn vertex that lies farthest from a point, in world space.
[[nodiscard]] double farthestDistance(const Scene&, glm::dvec3 point);

}  // namespace inkedge

#pragma once

#include <span>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

namespace inkedge {

/// Meshes, the box of each one's positions less its origin, and where they stand. Instances whose box cannot reach
/// further than what is already found are not looked into.
struct PlacedBoxes {
    std::span<const Mesh> meshes;
    std::span<const Box> boxes;  ///< one a mesh
    std::span<const Instance> instances;
};

/// The largest dot product of a direction with any drawn vertex, in world space.
[[nodiscard]] double support(const Scene&, glm::dvec3 direction);

/// The box of all drawn vertices, in world space.
[[nodiscard]] Box boxOfAll(const PlacedBoxes&);

/// The distance of the drawn vertex that lies farthest from a point, in world space.
[[nodiscard]] double farthestDistance(const PlacedBoxes&, glm::dvec3 point);

}  // namespace inkedge

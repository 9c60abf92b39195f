#pragma once

#include <functional>
#include <span>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Instances of meshes, and the box of each mesh: of its positions less its origin. The vertices of an instance are
/// skipped if its box cannot change a result. Instances whose vertices all lie at one point do not count, unless none
/// has an extent.
struct InstancedBoxes {
    std::span<const Mesh> meshes;
    std::span<const Box> boxes;  ///< one per mesh
    std::span<const Instance> instances;
};

/// Calls an action for every instance that counts, and its mesh, whose vertices are all drawn.
void forEachInstance(const Scene&, const std::function<void(const Instance&, const Mesh&)>& action);

/// The largest dot product of a direction and a drawn vertex, in world space.
[[nodiscard]] double support(const Scene&, glm::dvec3 direction);

/// The box of all drawn vertices, in world space.
[[nodiscard]] Box boxOfAll(const InstancedBoxes&);

/// The distance of the drawn vertex that lies farthest from a point, in world space.
[[nodiscard]] double farthestDistance(const InstancedBoxes&, glm::dvec3 point);

}  // namespace inkedge::scene

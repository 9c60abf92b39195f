#pragma once

#include <inkedge/camera.h>
#include <inkedge/scene.h>

namespace inkedge::camera {

/// Whether the camera stands outside the scene and its near plane does not cut the scene. No back of a closed mesh is
/// then seen.
[[nodiscard]] inline bool standsOutside(const Camera& camera, const Scene& scene) {
    const Sphere& bounds = scene.bounds();
    return -(camera.view * glm::dvec4{bounds.centre, 1.0}).z - bounds.radius >= camera.near;
}

}  // namespace inkedge::camera

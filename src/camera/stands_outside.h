#pragma once

#include <inkedge/camera.h>
#include <inkedge/scene.h>

namespace inkedge {

/// Whether the camera stands outside the scene and its near plane cuts none of it: then no back of a closed mesh is
/// seen.
[[nodiscard]] inline bool standsOutside(const Camera& camera, const Scene& scene) {
    const Sphere& bounds = scene.bounds();
    return -(camera.view * glm::dvec4{bounds.centre, 1.0}).z - bounds.radius >= camera.near;
}

}  // namespace inkedge

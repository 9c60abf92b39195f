#pragma once

#include <glm/vec3.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge::camera {

/// The direction towards the light of a Shade: view space, unit length.
[[nodiscard]] glm::dvec3 towardsLight(const Scene&, const Camera&, LightDirection, LightSpace);

}  // namespace inkedge::camera

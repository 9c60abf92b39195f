#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <inkedge/camera.h>

namespace inkedge::io {

/// World -> camera as OpenCV has it: x right, y down, z into the scene.
[[nodiscard]] glm::dmat4 worldToCamera(const Camera&);
/// That camera's space -> pixels, (0, 0) the middle of the first one: of x/z, y/z and 1; of x, y and 1 in an
/// orthographic view.
[[nodiscard]] glm::dmat3 intrinsics(const Camera&, Size);

/// Depth that a step of the grey levels of a depth map in a PNG stands for; the first level is Camera::near.
[[nodiscard]] inline double depthScale(const Camera& camera) noexcept { return (camera.far - camera.near) / 65535.0; }

}  // namespace inkedge::io

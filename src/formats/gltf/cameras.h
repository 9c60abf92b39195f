#pragma once

#include <optional>
#include <string>

#include <inkedge/scene.h>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// A camera's transform without scale, shear and reflection, which do not count for a camera of glTF.
[[nodiscard]] glm::dmat4 rigid(const glm::dmat4& transform);

/// Fills in the camera's lens.
/// @return  why there is no usable lens, in words; none: there is one
[[nodiscard]] std::optional<std::string> readLens(const tinygltf::Camera& source, SceneCamera& camera);

}  // namespace inkedge::gltf

#pragma once

#include <optional>
#include <string>

#include <inkedge/scene.h>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// A camera's transform without scale, shear and reflection, which glTF has a camera ignore.
[[nodiscard]] glm::dmat4 rigid(const glm::dmat4& transform);

/// Fills in the camera's lens.
/// @return  in words, why it has none
[[nodiscard]] std::optional<std::string> readLens(const tinygltf::Camera& source, SceneCamera& camera);

}  // namespace inkedge::gltf

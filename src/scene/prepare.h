#pragma once

#include <inkedge/scene.h>

#include "scene/prepared.h"

namespace inkedge::scene {

/// Checks a scene's data, brings its meshes into the form that is drawn, and computes what they have together.
/// @throws Error  as the constructor of Scene
[[nodiscard]] PreparedScene prepare(Scene::Data data, const LoadSettings& settings);

}  // namespace inkedge::scene

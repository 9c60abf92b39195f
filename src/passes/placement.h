#pragma once

#include <vector>

#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge {

/// Where each instance stands in view space, in the upload's order, and the matrix for its normals in the lights'
/// space.
[[nodiscard]] std::vector<gl::UploadedScene::PlacedInstance> placeInstances(const Frame&, LightSpace);

}  // namespace inkedge

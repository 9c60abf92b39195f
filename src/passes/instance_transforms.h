#pragma once

#include <vector>

#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge::passes {

/// The transform of each instance to view space, in the upload's order, and the matrix for its normals in the lights'
/// space.
[[nodiscard]] std::vector<gl::UploadedScene::InstanceTransforms> instanceTransforms(const Frame&, LightSpace);

}  // namespace inkedge::passes

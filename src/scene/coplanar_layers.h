#pragma once

#include <vector>

#include "scene/patch_numbers.h"

namespace inkedge::scene {

/// One flag per patch of an instance: whether one of its faces overlaps, in one plane, a face of a patch with another
/// number. Faces lie in one plane if they are within 1/500,000 of the scene's radius of the plane, whichever way they
/// face.
[[nodiscard]] std::vector<bool> findCoplanarLayers(const InstancedMeshes&, const PatchNumbers&);

}  // namespace inkedge::scene

#pragma once

#include <vector>

#include "scene/patch_numbers.h"

namespace inkedge {

/// One flag a patch of an instance: whether a face of it overlaps, in one plane, a face of a patch of another number.
/// Faces lie in one plane if they are within 1/500,000 of the scene's radius of it; which way they face does not
/// matter.
[[nodiscard]] std::vector<bool> findCoplanarLayers(const PlacedMeshes&, const PatchNumbers&);

}  // namespace inkedge

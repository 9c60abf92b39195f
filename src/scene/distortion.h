#pragma once

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Gives every instance whose transform changes angles (a shear, or scales that differ) a mesh of its own with the
/// distortion applied to its vertices. The angles between a mesh's faces are then always those seen in the world. The
/// instance's transform becomes a translation.
/// @throws Error  (Kind::Input) if the new meshes have over maxElements vertices and indices in all, or positions that
///                are not finite
void bakeDistortedInstances(Scene::Data&, std::uint64_t maxElements);

}  // namespace inkedge::scene

#pragma once

#include <inkedge/scene.h>

namespace inkedge {

/// Gives every instance whose transform changes angles (a shear, or scales that differ) a mesh of its own that has the
/// distortion in its vertices, so that angles between a mesh's faces are always those seen in the world. Its transform
/// then only moves.
/// @throws Error  (Kind::Input) if the meshes made have over mostElements vertices and indices in all, or positions
///                that are not finite
void bakeDistortedInstances(Scene::Data&, std::uint64_t mostElements);

}  // namespace inkedge

#pragma once

#include <inkedge/scene.h>

namespace inkedge {

/// Gives every instance whose transform changes angles (a shear, or scales that differ) a mesh of its own that has the
/// distortion in its vertices, so that angles between a mesh's faces are always those seen in the world. Its transform
/// then only moves.
void bakeDistortedInstances(Scene::Data&);

}  // namespace inkedge

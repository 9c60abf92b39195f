#pragma once

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Leaves out the instances that LoadSettings::only and ::hide leave out, and the meshes that no other instance has.
/// Adds a warning for each name that no node bears.
/// @throws Error  (Kind::Usage) if nothing is left; the message lists names that there are
void chooseNodes(Scene::Data&, const LoadSettings&);

/// Leaves out the meshes that no instance has.
void dropUnusedMeshes(Scene::Data&);

}  // namespace inkedge::scene

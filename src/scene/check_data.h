#pragma once

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Checks what a file or a caller gave.
/// @throws Error  (Kind::Input) if an index, a count or a coordinate is out of range or not finite; the message names
///                the mesh, the instance or the node, and the element
void checkData(const Scene::Data&);

}  // namespace inkedge::scene

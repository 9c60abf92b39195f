#pragma once

#include <inkedge/scene.h>

namespace inkedge::scene {

/// The median bend between two facets of a smooth surface of the scene, weighted by the length of the edge that they
/// share; degrees. Creases, edges within polygons and edges that do not bend are left out; 1 if no edge is left. Of
/// large scenes only a sample of the edges is looked at.
[[nodiscard]] double typicalBend(const Scene&);

}  // namespace inkedge::scene

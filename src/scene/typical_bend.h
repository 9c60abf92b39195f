#pragma once

#include <inkedge/scene.h>

namespace inkedge {

/// Degrees: the median bend between two facets of a smooth surface of the scene, by the length of the edge that they
/// share. Creases, edges within polygons and those that do not bend at all take no part; 1 if no edge is left.
/// Of large scenes a part of the edges stands for all.
[[nodiscard]] double typicalBend(const Scene&);

}  // namespace inkedge

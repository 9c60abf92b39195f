#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/scene.h>

#include "scene/union_find.h"

namespace inkedge {

/// Joins the patches on both sides of every seam: two mesh borders that run along each other within 1/20,000 of the
/// scene's radius, bent there by less than the crease angle. O(b log b + pairs of borders that are near each other).
/// @param base    where each instance's patches begin
/// @param joined  sets of all instances' patches
void joinAcrossSeams(const Scene&, const std::vector<std::uint32_t>& base, double creaseAngle, UnionFind& joined);

}  // namespace inkedge

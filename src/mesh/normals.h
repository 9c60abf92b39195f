#pragma once

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Gives every vertex without a normal (an empty array, or zero vectors) a normal: that of its face or, under
/// Normals::Auto, a smooth one. Of the faces around a point, those connected across edges that are no creases
/// share a smooth normal, in which each face is weighted by the angle of its corner. Vertices are split
/// where their faces do not share a normal. The topology stays valid: corners keep their order. O(n).
void completeNormals(Mesh&, const MeshTopology&, const LoadSettings&);

}  // namespace inkedge::mesh

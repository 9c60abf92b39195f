#pragma once

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge {

/// Makes each triangle's winding agree with its normals, so that the side which the normals point to is the front, and
/// drops the normals that are not finite, or all if settings ask for none of the file's.
void applyAuthoredNormals(Mesh&, const LoadSettings&);

/// Gives every vertex without a normal (an empty array, or zero vectors) one: its face's, or, under Normals::Auto, a
/// smooth one: of the faces around a point, those joined across edges that bend by no more than the crease angle share
/// a normal, weighted by the angle of each face's corner. Vertices are split where their faces do not share. The
/// topology stays valid: corners keep their order. O(n).
void completeNormals(Mesh&, const MeshTopology&, const LoadSettings&);

}  // namespace inkedge

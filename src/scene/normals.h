#pragma once

#include <inkedge/scene.h>

namespace inkedge {

/// Gives every vertex of a mesh its unit normal and makes each triangle's winding agree with its normals, so that the
/// side which the normals point to is the front.
///
/// Normals that are missing (an empty array, or zero vectors) or unwanted (Normals::Flat) are made: one per face, or, under
/// Normals::Auto, smooth: of the faces around a position, those joined across edges that bend by no more than the crease
/// angle share a normal, weighted by the angle of each face's corner. Vertices are split where their faces do not share.
/// O(n).
void completeNormals(Mesh&, const LoadSettings&);

}  // namespace inkedge

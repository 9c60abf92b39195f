#pragma once

#include <numbers>
#include <vector>

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Radians: normals that differ by less are one, which was rounded.
inline constexpr double sameNormal = 4.0 * std::numbers::pi / 180.0;

/// Drops normals that are not finite, and all normals of the file if the settings ask for none of them. The mesh has
/// then one normal a vertex; zero vectors are yet to be made.
void keepUsableNormals(Mesh&, const LoadSettings&);

/// Decides for each component of a mesh whether the file's normals deserve belief, and turns faces over where they and
/// the winding contradict each other.
///
/// A normal that faces share lies among theirs. Where more than a quarter of a component's corners have a normal that
/// does not, within 10 degrees, the component's are not believed: they are random, stand in other axes than the
/// positions, or belong to another shape. Nor are those believed that are turned over against a consistent winding;
/// but if that winding is the one that encloses a negative volume, the faces are turned over instead. In a component
/// whose winding is not consistent, believed normals decide face by face.
///
/// Normals that are not believed become zero, unless settings.normals is Normals::Authored.
/// @return  one per face: whether it has no believed normals; empty if all are believed
/// O(n).
[[nodiscard]] std::vector<bool> judgeNormals(Mesh&, MeshTopology&, const LoadSettings&);

}  // namespace inkedge::mesh

#pragma once

#include <vector>

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Degrees by which an edge must bend to be a crease although the file's normals are shared across it.
[[nodiscard]] double sharedCreaseAngle(const LoadSettings&);

/// Fills MeshTopology::creases. What an edge is follows from its kind (EdgeKind::Sharp is a crease; Inner, Tangent and
/// Seam are none), from the bend of its two faces, and from the file's normals on both sides, as settings.creases says:
///
/// - Creases::Angle: a crease bends by more than the crease angle.
/// - Creases::Normals: a crease is where the normals are split. Where an edge has none, its bend decides.
/// - Creases::Auto: where the normals are shared, the author drew the edge smooth: a crease bends by more than twice
///   the crease angle. Where they are split about as much as the faces bend, it bends by 9 degrees at least; but not in
///   a component that is made of facets, where split normals say nothing, nor where up to three such edges stand alone.
///   There, where normals are missing, not believed, or split much more or less than the faces bend, the crease angle
///   decides.
///
/// On the rough surfaces of scans creases are carried on, where they end, by edges that bend by three fifths of their
/// angle, and those of fewer than six edges are none.
///
/// No decision hangs on rounding: within a degree of an angle (Creases::Angle: a tenth), and where normals are split at
/// one end only, an edge is a crease only if it carries on one that is beyond doubt.
/// @param mesh         with the file's normals, zero where it has none
/// @param disbelieved  as judgeNormals() gives it
/// O(n log n) at worst, O(n) if few edges are in doubt.
void findCreases(const Mesh& mesh, const std::vector<bool>& disbelieved, const LoadSettings&, MeshTopology&);

}  // namespace inkedge::mesh

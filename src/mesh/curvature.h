#pragma once

#include <vector>

#include <inkedge/bounds.h>
#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Mean curvature at each vertex, in 1 / unit of mesh space; over 0 where the surface bulges towards its front.
///
/// Vertices at one position within a patch have one curvature. An edge of two faces bends the surface by the angle
/// between the faces. At a point the edges' half lengths times angles are summed, each edge shared by its two ends; the
/// sum is divided by the point's share of its faces' area, and halved. The integral of this over a surface is that of
/// Steiner's formula (Cohen-Steiner and Morvan 2003).
///
/// Both sums are smoothed over the mesh by about a Gaussian of 0.8 % of its extent, so that the roughness of a scan
/// does not count. A mesh whose edges are longer than that is not smoothed. Creases, borders and edges of three or more
/// faces bend nothing. O(n).
[[nodiscard]] std::vector<float> meanCurvatures(const Mesh&, const MeshTopology&);

}  // namespace inkedge::mesh

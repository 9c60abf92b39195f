#pragma once

#include <vector>

#include <inkedge/bounds.h>
#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge {

/// Mean curvature at each vertex, one over mesh space's unit; over 0 where the surface bulges towards its front.
/// Vertices at one place within a patch have one curvature. Each edge of two faces bends the surface by its angle: the
/// sum of half its length times that angle over the edges around a point, each shared by its two ends, over the point's
/// share of its faces' area, halved; its integral over a surface is that of Steiner's formula (Cohen-Steiner and Morvan
/// 2003). Both sums are spread over the mesh by about a Gaussian of 0.8 % of its extent, so that the roughness of a
/// scan is none; of a mesh with edges longer than that each point has its own. Creases end what bends, as borders and
/// edges of three faces and more do. O(n).
[[nodiscard]] std::vector<float> meanCurvatures(const Mesh&, const MeshTopology&);

}  // namespace inkedge

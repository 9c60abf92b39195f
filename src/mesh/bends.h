#pragma once

#include <cstddef>
#include <vector>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

struct EdgeBend {
    double bend;    ///< degrees
    double length;  ///< of the edge
};

/// The step from one half-edge to the next of a sample of about as many as wanted, of all three sides of triangles.
[[nodiscard]] std::size_t strideOf(std::size_t halfEdges, std::size_t wanted) noexcept;

/// The median of the bends, weighted by the edges' lengths; otherwise, if there are none.
[[nodiscard]] double medianOf(std::vector<EdgeBend> edges, double otherwise);

/// The median bend of the edges of two faces, flat ones among them; degrees, 0 if there are none. Of large meshes only
/// a sample of the edges is looked at.
[[nodiscard]] double medianBend(const Mesh&, const MeshTopology&);

}  // namespace inkedge::mesh

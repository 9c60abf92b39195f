#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Which faces are connected across edges that two faces share.
struct Components {
    std::vector<std::uint32_t> ofFaces;  ///< one per triangle: 0..count-1, in the order of their first faces
    std::uint32_t count = 0;
};
/// O(n), quicker with MeshTopology::patches.
[[nodiscard]] Components findComponents(const MeshTopology&);

/// The orientation of each face's connected component, one per face. 1 or -1: the component is closed (each edge has
/// two faces) and wound consistently, outward (its signed volume is over 0) or inward. 0: it is not. Faces that repeat
/// another face, or have collapsed to a line or a point, do not count. O(n).
[[nodiscard]] std::vector<std::int8_t> componentOrientations(const Mesh&, const MeshTopology&);

/// Whether every connected component of a mesh is closed (each edge has two faces), wound consistently, and outward
/// (its signed volume is over 0). From outside only fronts of faces are then seen, unless the mesh runs through itself
/// so that a component is inside out. Faces collapsed to a line or a point do not matter. O(n).
[[nodiscard]] bool isClosedOutward(const Mesh&, const MeshTopology&);

}  // namespace inkedge::mesh

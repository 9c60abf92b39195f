#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge {

/// One a face: 1 or -1 if the part that hangs together with it is closed (each edge has two faces), wound consistently,
/// and outward (its signed volume is over 0) or inward; else 0. Faces that repeat another and those collapsed to a line
/// or a point take no part. O(n).
[[nodiscard]] std::vector<std::int8_t> closedParts(const Mesh&, const MeshTopology&);

/// Whether every part of a mesh that hangs together is closed (each edge has two faces), wound consistently, and
/// outward (its signed volume is over 0): from outside only fronts of its faces are seen, unless it runs through itself
/// so that a part is inside out. Faces collapsed to a line or a point do not matter. O(n).
[[nodiscard]] bool isClosedOutward(const Mesh&, const MeshTopology&);

}  // namespace inkedge

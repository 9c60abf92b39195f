#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// The corners around a point that are connected across edges that are no creases form a fan: there the surface is
/// smooth. One per corner: the first corner of its fan. O(n).
[[nodiscard]] std::vector<std::uint32_t> findFans(const MeshTopology&);

}  // namespace inkedge::mesh

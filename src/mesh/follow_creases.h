#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

/// Of some edges, those that are too little to be a line: fewer than four of them hang together, and they touch no
/// crease, no border, and no edge of more than two faces.
/// @param halfEdges  with a twin, one an edge; none is a crease yet
/// @return           one per half-edge
/// O(half-edges of the mesh).
[[nodiscard]] std::vector<bool> standAlone(const MeshTopology&, std::span<const std::uint32_t> halfEdges);

/// Makes creases of those doubtful edges that carry on a crease: they share a point with one, and leave it within 60
/// degrees of its direction, perhaps by way of other doubtful edges.
/// @param doubtful  half-edges with a twin, one an edge
/// O(half-edges + n log n) for n doubtful edges; O(1) if there are none.
void followCreases(const Mesh&, std::span<const std::uint32_t> doubtful, MeshTopology&);

/// Carries lines of creases on where they end, along the straightest of the weak edges there, within 60 degrees of
/// their direction: line by line, so that no net of edges grows.
/// @param weak  as doubtful
/// O(half-edges + n log n) for n weak edges.
void extendCreases(const Mesh&, std::span<const std::uint32_t> weak, MeshTopology&);

/// Takes back the creases that fewer edges than minEdges make together, unless they touch a border or an edge of more
/// than two faces, or one is EdgeKind::Sharp. O(half-edges).
void dropShortChains(const Mesh&, std::uint32_t minEdges, MeshTopology&);

}  // namespace inkedge::mesh

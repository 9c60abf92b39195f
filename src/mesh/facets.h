#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/mesh.h>

#include "base/union_find.h"
#include "mesh/topology.h"

namespace inkedge::mesh {

/// What the file's normals say of the edges that bend by less than the crease angle, but by some degrees at least.
struct SplitEdges {
    std::span<const std::uint32_t> split;   ///< half-edges, one an edge: the normals on both sides differ
    std::span<const std::uint32_t> shared;  ///< likewise: they are the same
};

/// The components of a mesh that are made of facets: exported with normals that split across nearly every bend, so that
/// a split says nothing. More than three tenths of the length of such edges is split, and the split edges run loose
/// within the regions that smooth edges hold together, or connect the regions to rows or nets, three pairs or more for
/// four regions. Where they part two large regions, or a few, they were chosen.
class Facets {
public:
    Facets(const Mesh&, const MeshTopology&, const SplitEdges&);

    /// Whether a face is part of such a component.
    [[nodiscard]] bool contain(std::uint32_t face) const { return faceted_[components_.root(face)]; }

private:
    mutable base::UnionFind components_;
    std::vector<bool> faceted_;
};

}  // namespace inkedge::mesh

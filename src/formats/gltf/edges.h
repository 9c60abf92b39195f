#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/edge_kinds.h>

#include "formats/gltf/model.h"
#include "formats/gltf/triangles.h"

namespace inkedge::gltf {

/// What EXT_mesh_primitive_edge_visibility says of a primitive's edges.
struct EdgeVisibility {
    /// One an index of triangleList(), of the edge from that corner to its triangle's next: EdgeKind::Marked, to be
    /// drawn always; EdgeKind::Inner, to be drawn never, or only as silhouette: the surface is smooth there; or
    /// neither. Empty: the primitive does not have the extension.
    std::vector<EdgeKinds> kinds;
    std::size_t lost = 0;  ///< line strings' edges that belong to no triangle drawn
};

/// Materials, and normals for silhouettes, are not read.
/// @param corners  the primitive's vertex indices in the order of the file
/// @throws Error  (Kind::Input) if the extension has neither visibility nor lineStrings; if an accessor is missing, not
///                of the type it should be or not of the size; if an index is out of range
[[nodiscard]] EdgeVisibility readEdgeVisibility(const tinygltf::Model&, const tinygltf::Primitive&, Mode,
                                                std::span<const std::uint32_t> corners, std::size_t vertexCount);

}  // namespace inkedge::gltf

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
    /// One per index of triangleList(): the kinds of the edge from that corner to the next of its triangle.
    /// EdgeKind::Marked: always drawn. EdgeKind::Inner: never drawn, or only as a silhouette, for the surface is smooth
    /// there. Empty: the primitive does not have the extension.
    std::vector<EdgeKinds> kinds;
    std::size_t lost = 0;  ///< edges of line strings that belong to no drawn triangle
};

/// Reads the extension, without its materials and its normals for silhouettes.
/// @param corners  the primitive's vertex indices in the order of the file
/// @throws Error  (Kind::Input) if the extension has neither visibility nor lineStrings; if an accessor is missing, not
///                of the type it should be or not of the size; if an index is out of range
[[nodiscard]] EdgeVisibility readEdgeVisibility(const tinygltf::Model&, const tinygltf::Primitive&, Mode,
                                                std::span<const std::uint32_t> corners, std::size_t vertexCount);

}  // namespace inkedge::gltf

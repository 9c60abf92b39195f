#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/edge_kinds.h>

#include "formats/gltf/model.h"
#include "formats/gltf/triangles.h"

namespace inkedge::gltf {

/// What EXT_mesh_primitive_edge_visibility and CESIUM_primitive_outline say of a primitive's edges.
struct FileEdges {
    /// One per index of triangleList(): the kinds of the edge from that corner to the next of its triangle.
    /// EdgeKind::Marked: always drawn. EdgeKind::Inner: never drawn, or only as a silhouette, for the surface is smooth
    /// there. Empty: the primitive has neither extension.
    std::vector<EdgeKinds> kinds;
    std::vector<std::uint32_t> lines;  ///< edges of no drawn triangle: two vertices each
};

/// Reads the extensions, without the materials and the normals for silhouettes of the first.
/// @param corners  the primitive's vertex indices in the order of the file
/// @throws Error  (Kind::Input) if an extension lacks what it must have; if an accessor is missing, not of the type it
///                should be or not of the size; if an index is out of range
[[nodiscard]] FileEdges readEdges(const tinygltf::Model&, const tinygltf::Primitive&, Mode,
                                  std::span<const std::uint32_t> corners, std::size_t vertexCount);

}  // namespace inkedge::gltf

#pragma once

#include <span>
#include <vector>

#include "formats/gltf/file.h"
#include "formats/gltf/mask_levels.h"
#include "formats/gltf/model.h"
#include "formats/gltf/nodes.h"

namespace inkedge::gltf {

/// The material of a primitive; null if it has none, or one that the file does not have: the shape does not depend on
/// it.
/// @throws Error  (Kind::Input) if the number is below 0
[[nodiscard]] const Material* materialOf(const File&, const tinygltf::Primitive&);

/// The vertex indices of a primitive, and restarts if the file may have them.
/// @throws Error  (Kind::Input) as readIndices()
[[nodiscard]] std::vector<std::uint32_t> cornersOf(const tinygltf::Model&, const File&, const tinygltf::Primitive&,
                                                   std::size_t vertexCount);

/// The opacity of a primitive's vertices: the alpha of COLOR_0; all 1 where there is none.
/// @throws Error  (Kind::Input) if it is not finite, or its accessor does not fit
[[nodiscard]] std::vector<double> vertexOpacities(const tinygltf::Model&, const tinygltf::Primitive&,
                                                  std::size_t count);

/// Whether the opacity of the vertices changes within a triangle. Triangles that share an edge must be cut in one way,
/// so that one that varies decides for all.
[[nodiscard]] bool varies(const std::vector<double>& opacities, std::span<const std::uint32_t> triangles);

/// The masks that are cut in what these nodes draw. What cannot be read is left out: who draws it says why.
/// @param maxElements  vertices and indices that are looked at
[[nodiscard]] std::vector<MaskUse> maskUses(const tinygltf::Model&, const File&, const std::vector<DrawnNode>&,
                                            std::uint64_t maxElements);

}  // namespace inkedge::gltf

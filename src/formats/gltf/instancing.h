#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// The transforms of the copies that EXT_mesh_gpu_instancing makes of a node's mesh, in the node's space; one without
/// the extension.
/// @throws Error  (Kind::Input) if there are over maxCopies, or their accessors do not agree
[[nodiscard]] std::vector<glm::dmat4> copiesOf(const tinygltf::Model&, const tinygltf::Node&, std::uint64_t maxCopies);

}  // namespace inkedge::gltf

#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// The copies that EXT_mesh_gpu_instancing makes of a node's mesh, in the node's space; without it, one.
/// @throws Error  (Kind::Input) if there are more than `most`, or their accessors do not agree
[[nodiscard]] std::vector<glm::dmat4> copiesOf(const tinygltf::Model&, const tinygltf::Node&, std::uint64_t most);

}  // namespace inkedge::gltf

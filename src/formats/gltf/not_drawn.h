#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formats/gltf/model.h"
#include "formats/gltf/nodes.h"

namespace inkedge::gltf {

/// What the meshes of a scene hold that is not drawn.
struct NotDrawn {
    std::uint64_t points = 0;
    std::uint64_t maskedAway = 0;   ///< triangles
    std::uint64_t maskedLines = 0;  ///< pieces of lines
    std::uint64_t transparent = 0;  ///< primitives that LoadSettings::transparent leaves out

    /// Adds the points of a primitive. What its accessors say is not checked.
    void addPoints(const tinygltf::Model&, const tinygltf::Primitive&);
};

/// What a file holds whose scene draws nothing, in words: "8 points", "2 meshes that no node draws".
/// @param drawn  nodesOfScene() of the scene
/// @param scene  LoadSettings::scene
[[nodiscard]] std::vector<std::string> whatIsThere(const tinygltf::Model&, const Nodes&,
                                                   std::span<const DrawnNode> drawn, std::optional<int> scene,
                                                   const NotDrawn&);

}  // namespace inkedge::gltf

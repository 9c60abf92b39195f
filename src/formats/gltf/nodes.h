#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <inkedge/settings.h>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// Sets whether KHR_node_visibility hides a node.
void setVisible(tinygltf::Node&, bool visible);

/// The node trees of a file.
struct Nodes {
    std::vector<int> parents;         ///< -1: a root
    std::vector<glm::dmat4> toWorld;  ///< node space -> world
};

/// Checks that the nodes form trees, and computes their transforms. Works without recursion, as chains may be long.
/// @throws Error  (Kind::Input) if a node has two parents, is among its own descendants, has no finite affine
///                transform, or there are more of them, or they hang deeper, than the limits allow
[[nodiscard]] Nodes nodeTransforms(const tinygltf::Model&, const LoadLimits&);

/// A node of the scene that is drawn.
struct DrawnNode {
    std::size_t node;
    bool visible;  ///< false: KHR_node_visibility hides the node or an ancestor
};

/// The nodes of a scene, parents before their children.
/// @param scene   none: the default scene's, else the first scene's, else all nodes
/// @throws Error  (Kind::Usage) if there is no such scene; (Kind::Input) if a node is in it twice
[[nodiscard]] std::vector<DrawnNode> nodesOfScene(const tinygltf::Model&, const Nodes&, std::optional<int> scene);

/// Translation, rotation (a quaternion x y z w, of any length) and scale as one matrix.
[[nodiscard]] glm::dmat4 compose(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale);

}  // namespace inkedge::gltf

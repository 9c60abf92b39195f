#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// Sets the nodes (translation, rotation, scale, morph weights) to their pose in an animation at a time; glTF 2.0,
/// section 3.11 and appendix C. Pointers of KHR_animation_pointer may drive the same, weights of meshes, and whether
/// KHR_node_visibility hides a node. Before its first key and after its last a channel holds that key's value.
/// @param animation  a name, else a number from 0
/// @param time       seconds
/// @return           warnings of what the animation drives that is not read
/// @throws Error     (Kind::Usage) if there is no such animation: the message lists those that there are;
///                   (Kind::Input) if the animation is damaged
[[nodiscard]] std::vector<std::string> poseNodes(tinygltf::Model&, std::string_view animation, double time);

}  // namespace inkedge::gltf

#pragma once

#include <cstddef>
#include <optional>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// What a channel of an animation drives.
struct AnimationTarget {
    enum class Property { Translation, Rotation, Scale, Weights, Visible };
    Property property = Property::Translation;
    bool ofMesh = false;                 ///< false: of a node
    int index = -1;                      ///< of the node or mesh; unchecked
    std::optional<std::size_t> element;  ///< the one weight that is driven; none: all of them; unchecked
};

/// The target of a channel: of glTF 2.0, section 3.11, or of KHR_animation_pointer.
/// @return  none if the channel drives what is not read
[[nodiscard]] std::optional<AnimationTarget> targetOf(const tinygltf::AnimationChannel&);

}  // namespace inkedge::gltf

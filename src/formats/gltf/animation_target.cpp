#include "formats/gltf/animation_target.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "formats/text.h"

namespace inkedge::gltf {

namespace {

using Property = AnimationTarget::Property;

std::optional<Property> propertyOf(std::string_view path) {
    static constexpr std::pair<std::string_view, Property> properties[]{{"translation", Property::Translation},
                                                                        {"rotation", Property::Rotation},
                                                                        {"scale", Property::Scale},
                                                                        {"weights", Property::Weights}};
    const auto* const found = std::ranges::find(properties, path, &std::pair<std::string_view, Property>::first);
    if (found == std::end(properties)) return {};
    return found->second;
}

// The first step of a JSON pointer, "/nodes" of "/nodes/0/scale", which is removed from it.
std::string_view takeStep(std::string_view& pointer) {
    const std::string_view step = pointer.substr(0, pointer.find('/', 1));
    pointer.remove_prefix(step.size());
    return step;
}

template <class Number>
std::optional<Number> numberIn(std::string_view step) {
    if (step.size() < 2 || step[1] < '0' || step[1] > '9') return {};
    return formats::toNumber<Number>(step.substr(1));
}

std::optional<AnimationTarget> resolve(std::string_view pointer) {
    const std::string_view list = takeStep(pointer);
    if (list != "/nodes" && list != "/meshes") return {};
    const std::optional<int> index = numberIn<int>(takeStep(pointer));
    if (!index) return {};
    AnimationTarget target{Property::Visible, list == "/meshes", *index, {}};
    if (!target.ofMesh && pointer == "/extensions/KHR_node_visibility/visible") return target;
    const std::string_view step = takeStep(pointer);
    const std::optional<Property> property = propertyOf(step.substr(step.empty() ? 0 : 1));
    if (!property || (target.ofMesh && *property != Property::Weights)) return {};
    target.property = *property;
    if (pointer.empty()) return target;
    target.element = numberIn<std::size_t>(pointer);
    if (*property != Property::Weights || !target.element) return {};
    return target;
}

}  // namespace

std::optional<AnimationTarget> targetOf(const tinygltf::AnimationChannel& channel) {
    if (channel.target_path == "pointer") {
        const auto extension = channel.target_extensions.find("KHR_animation_pointer");
        if (extension == channel.target_extensions.end()) return {};
        const tinygltf::Value& pointer = member(extension->second, "pointer");
        return pointer.IsString() ? resolve(pointer.Get<std::string>()) : std::nullopt;
    }
    const std::optional<Property> property = propertyOf(channel.target_path);
    if (!property) return {};
    return AnimationTarget{*property, false, channel.target_node, {}};
}

}  // namespace inkedge::gltf

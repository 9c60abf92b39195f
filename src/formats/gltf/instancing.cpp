#include "formats/gltf/instancing.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/gltf/attributes.h"
#include "formats/gltf/nodes.h"

namespace inkedge::gltf {

using base::refuse;

std::vector<glm::dmat4> copiesOf(const tinygltf::Model& model, const tinygltf::Node& node, std::uint64_t maxCopies) {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end()) return {glm::dmat4{1.0}};
    const tinygltf::Value& attributes = member(extension->second, "attributes");
    std::optional<std::size_t> count;
    const auto read = [&]<class Vector>(const char* name, const Expected& expected, Vector otherwise) {
        std::vector<Vector> vectors;
        const tinygltf::Value& index = member(attributes, name);
        if (index.IsInt()) {
            if (const std::uint64_t copies = elementCount(model, index.GetNumberAsInt(), name); copies > maxCopies)
                base::refuse(
                    fmt::format("expected at most {} more instances in the scene, found {}; raise max-instances",
                                maxCopies, copies));
            vectors = readVectors<Vector>(model, index.GetNumberAsInt(), name, expected);
            if (count && *count != vectors.size())
                refuse(fmt::format("{}: expected as many instances as before, {}, found {}", name, *count,
                                   vectors.size()));
            count = vectors.size();
        }
        return [vectors = std::move(vectors), otherwise](std::size_t i) {
            return vectors.empty() ? otherwise : vectors[i];
        };
    };
    return base::within("EXT_mesh_gpu_instancing", [&] {
        const auto translation = read("TRANSLATION", floatVec3, glm::dvec3{0.0});
        const auto rotation = read("ROTATION", anyRotation, glm::dvec4{0, 0, 0, 1});
        const auto scale = read("SCALE", floatVec3, glm::dvec3{1.0});
        std::vector<glm::dmat4> copies;
        for (std::size_t i = 0; i < count.value_or(1); ++i)
            copies.push_back(compose(translation(i), rotation(i), scale(i)));
        return copies;
    });
}

}  // namespace inkedge::gltf

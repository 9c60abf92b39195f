#include "formats/gltf/paint.h"

#include <limits>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/gltf/attributes.h"
#include "formats/gltf/uri.h"

namespace inkedge::gltf {

TextureWrap wrapOf(Wrap wrap) {
    switch (wrap) {
        case Wrap::Clamp:
            return TextureWrap::Clamp;
        case Wrap::Mirror:
            return TextureWrap::Mirror;
        case Wrap::Repeat:
            break;
    }
    return TextureWrap::Repeat;
}

base::Bytes pictureBytes(const tinygltf::Model& model, const formats::ModelInput& input, const Image& source,
                         std::uint64_t& bytesLeft) {
    if (!source.bufferView) return readUri(input, source.uri, bytesLeft);
    if (*source.bufferView > std::numeric_limits<int>::max())
        base::refuse(fmt::format("expected a bufferView, found {}", *source.bufferView));
    const auto view = viewBytes(model, static_cast<int>(*source.bufferView));
    return {view.begin(), view.end()};
}

const Image& imageOf(const File& file, const Texture& texture) {
    if (!texture.image)
        base::refuse("expected its picture as PNG, JPEG or WebP, found " +
                     (texture.otherForm.empty() ? "none" : "it in another form only, by " + texture.otherForm));
    if (*texture.image >= file.images.size())
        base::refuse(fmt::format("expected an image below {}, found {}", file.images.size(), *texture.image));
    return file.images[*texture.image];
}

std::vector<glm::dvec2> uvsOf(const tinygltf::Model& model, const Texture& texture,
                              const tinygltf::Primitive& primitive, std::size_t count) {
    const std::string name = fmt::format("TEXCOORD_{}", texture.set);
    std::vector<glm::dvec2> uvs = readAttribute<glm::dvec2>(model, primitive.attributes, name, anyCoordinates, count);
    for (glm::dvec2& uv : uvs) uv = texture.scale * uv + texture.offset;
    return uvs;
}

std::vector<glm::dvec4> vertexColors(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                     std::size_t count) {
    const auto color = primitive.attributes.find("COLOR_0");
    if (color == primitive.attributes.end()) return {};
    if (at(model.accessors, color->second, "an accessor").type == TINYGLTF_TYPE_VEC4)
        return readAttribute<glm::dvec4>(model, primitive.attributes, "COLOR_0", anyColor, count);
    std::vector<glm::dvec4> colors;
    for (const glm::dvec3& c : readAttribute<glm::dvec3>(model, primitive.attributes, "COLOR_0", anyOpaqueColor, count))
        colors.emplace_back(c, 1.0);
    return colors;
}

}  // namespace inkedge::gltf

#include "formats/gltf/materials.h"

#include <cmath>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

double real(const Json& object, const char* key, double otherwise) {
    const Json& value = member(object, key);
    if (value.is_null()) return otherwise;
    if (!value.is_number()) base::refuse(fmt::format("expected a number as {}, found {}", key, found(value)));
    return value.get<double>();
}

// The i-th number of a list.
double realIn(const Json& object, const char* key, std::size_t i, double otherwise) {
    const Json& list = member(object, key);
    if (list.is_null()) return otherwise;
    if (i >= sizeOf(list) || !list[i].is_number())
        base::refuse(fmt::format("expected over {} numbers as {}, found {}", i, key, found(list)));
    return list[i].get<double>();
}

Wrap wrapOf(const Json& sampler, const char* key) {
    const auto mode = static_cast<Wrap>(number(sampler, key, static_cast<std::uint64_t>(Wrap::Repeat)));
    if (mode != Wrap::Clamp && mode != Wrap::Mirror && mode != Wrap::Repeat)
        base::refuse(fmt::format("expected 33071, 33648 or 10497 as {}, found {}", key, static_cast<int>(mode)));
    return mode;
}

void transform(const Json& source, Texture& texture) {
    const double angle = real(source, "rotation", 0.0);
    const glm::dvec2 scale{realIn(source, "scale", 0, 1.0), realIn(source, "scale", 1, 1.0)};
    texture.scale = glm::dmat2{std::cos(angle) * scale.x, -std::sin(angle) * scale.x,  //
                               std::sin(angle) * scale.y, std::cos(angle) * scale.y};
    texture.offset = {realIn(source, "offset", 0, 0.0), realIn(source, "offset", 1, 0.0)};
    texture.set = number(source, "texCoord", texture.set);
}

// A texture has its picture as PNG or JPEG, in other forms by extensions, or both. Of the other forms WebP is read.
void readSource(const Json& source, Texture& texture) {
    const Json& webp = extension(source, "EXT_texture_webp");
    if (!member(source, "source").is_null())
        texture.image = number(source, "source");
    else if (!member(webp, "source").is_null())
        texture.image = number(webp, "source");
    else if (const Json& others = member(source, "extensions"); others.is_object() && !others.empty())
        texture.otherForm = base::printable(others.begin().key());
}

Texture readTexture(const Json& document, const Json& use) {
    Texture texture;
    texture.set = number(use, "texCoord", 0);
    if (const Json& its = extension(use, "KHR_texture_transform"); !its.is_null()) transform(its, texture);
    const Json& source = entry(document, "textures", number(use, "index"));
    readSource(source, texture);
    if (member(source, "sampler").is_null()) return texture;
    const Json& sampler = entry(document, "samplers", number(source, "sampler"));
    texture.wrapS = wrapOf(sampler, "wrapS");
    texture.wrapT = wrapOf(sampler, "wrapT");
    return texture;
}

Material::Alpha alphaOf(const std::string& mode) {
    if (mode == "OPAQUE") return Material::Alpha::Opaque;
    if (mode == "MASK") return Material::Alpha::Mask;
    if (mode == "BLEND") return Material::Alpha::Blend;
    base::refuse("expected OPAQUE, MASK or BLEND as alphaMode, found " + base::quote(mode));
}

// Reads factor and texture of the base colour.
void readBaseColor(const Json& document, const Json& source, Material& material) {
    const Json& specular = extension(source, "KHR_materials_pbrSpecularGlossiness");
    const Json& color = specular.is_null() ? member(source, "pbrMetallicRoughness") : specular;
    const char* const factor = specular.is_null() ? "baseColorFactor" : "diffuseFactor";
    material.opacity = realIn(color, factor, 3, 1.0);
    for (int i = 0; i < 3; ++i) material.color[i] = realIn(color, factor, static_cast<std::size_t>(i), 1.0);
    const Json& use = member(color, specular.is_null() ? "baseColorTexture" : "diffuseTexture");
    if (!use.is_null()) material.texture = readTexture(document, use);
}

Material readMaterial(const Json& document, const Json& source) {
    Material material;
    material.name = text(source, "name", "");
    material.alpha = alphaOf(text(source, "alphaMode", "OPAQUE"));
    material.doubleSided = member(source, "doubleSided") == true;
    if (material.alpha == Material::Alpha::Mask) {
        material.cutoff = real(source, "alphaCutoff", material.cutoff);
        readBaseColor(document, source, material);
        return material;
    }
    try {  // the shape does not depend on it
        readBaseColor(document, source, material);
    } catch (const Error& error) {
        material.unpainted = error.what();
    }
    return material;
}

}  // namespace

std::vector<Material> readMaterials(const Json& document) {
    const Json& list = member(document, "materials");
    std::vector<Material> materials;
    for (std::size_t i = 0; i < sizeOf(list); ++i)
        materials.push_back(base::within(base::label("material", i), [&] { return readMaterial(document, list[i]); }));
    return materials;
}

std::vector<Image> readImages(const Json& document) {
    const Json& list = member(document, "images");
    std::vector<Image> images;
    for (std::size_t i = 0; i < sizeOf(list); ++i) {
        base::within(base::label("image", i), [&] {
            Image image{text(list[i], "uri", ""), {}};
            if (!member(list[i], "bufferView").is_null()) image.bufferView = number(list[i], "bufferView");
            images.push_back(std::move(image));
        });
    }
    return images;
}

}  // namespace inkedge::gltf

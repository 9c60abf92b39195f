#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "formats/gltf/json.h"

namespace inkedge::gltf {

/// Which texel texture coordinates outside 0..1 stand for: sampler.wrapS and wrapT.
enum class Wrap : int { Clamp = 33071, Mirror = 33648, Repeat = 10497 };

/// A picture of the file.
struct Image {
    std::string uri;  ///< empty: in a bufferView
    std::optional<std::uint64_t> bufferView;
};

/// A picture as a material uses it.
struct Texture {
    std::optional<std::uint64_t> image;  ///< into the document's; none: in a form that is not read, if in any
    std::string otherForm;               ///< the extension that gives the picture in such a form
    std::uint64_t set = 0;               ///< TEXCOORD_n
    glm::dmat2 scale{1.0};  ///< KHR_texture_transform, with its rotation: uv = scale * coordinates + offset
    glm::dvec2 offset{0.0};
    Wrap wrapS = Wrap::Repeat;
    Wrap wrapT = Wrap::Repeat;
};

/// What a material says about the shape.
struct Material {
    enum class Alpha { Opaque, Mask, Blend };
    std::string name;
    Alpha alpha = Alpha::Opaque;
    double cutoff = 0.5;             ///< Mask: the surface has a hole where the opacity is less
    double opacity = 1.0;            ///< of the base colour's factor
    std::optional<Texture> texture;  ///< of the base colour: the opacity is multiplied by its alpha
    glm::dvec3 color{1.0};           ///< of the base colour's factor, linear
    std::string unpainted;           ///< why colour and texture are not known; Opaque and Blend only
    bool doubleSided = false;
};

/// @throws Error  (Kind::Input) if one is damaged; the message names it
[[nodiscard]] std::vector<Material> readMaterials(const Json& document);
[[nodiscard]] std::vector<Image> readImages(const Json& document);

}  // namespace inkedge::gltf

#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/scene.h>

#include "base/read_file.h"
#include "formats/gltf/file.h"
#include "formats/gltf/model.h"

/// What glTF's materials and vertices say of colours and pictures.
namespace inkedge::gltf {

[[nodiscard]] TextureWrap wrapOf(Wrap);

/// The bytes of a picture's file. The size of a file beside the model is subtracted from bytesLeft.
/// @throws Error  (Kind::Input) if it is missing or larger
[[nodiscard]] base::Bytes pictureBytes(const tinygltf::Model&, const formats::ModelInput&, const Image&,
                                       std::uint64_t& bytesLeft);

/// The picture of a texture.
/// @throws Error  (Kind::Input) if the file does not have it as PNG, JPEG or WebP
[[nodiscard]] const Image& imageOf(const File&, const Texture&);

/// Texture coordinates, one per vertex, after KHR_texture_transform; empty: the primitive has none.
/// @throws Error  (Kind::Input) if their accessor does not fit
[[nodiscard]] std::vector<glm::dvec2> uvsOf(const tinygltf::Model&, const Texture&, const tinygltf::Primitive&,
                                            std::size_t count);

/// Vertex colours, linear; none: all are white.
/// @throws Error  (Kind::Input) if their accessor does not fit
[[nodiscard]] std::vector<glm::dvec4> vertexColors(const tinygltf::Model&, const tinygltf::Primitive&,
                                                   std::size_t count);

}  // namespace inkedge::gltf

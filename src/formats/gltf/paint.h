#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <inkedge/scene.h>

#include "base/read_file.h"
#include "formats/gltf/file.h"
#include "formats/gltf/model.h"

/// What glTF's materials and vertices say of colours and pictures.
namespace inkedge::gltf {

[[nodiscard]] TextureWrap wrapOf(Wrap);

/// A picture's file. What is read from beside the model is taken off bytesLeft.
/// @throws Error  (Kind::Input) if it is missing or larger
[[nodiscard]] load::Bytes pictureBytes(const tinygltf::Model&, const std::filesystem::path& model, const Image&,
                                       std::uint64_t& bytesLeft);

/// @throws Error  (Kind::Input) if the file does not have it as PNG or JPEG
[[nodiscard]] const Image& imageOf(const File&, const Texture&);

/// What vertices say of the places in a material's picture; empty: nothing.
/// @throws Error  (Kind::Input) if their accessor does not fit
[[nodiscard]] std::vector<glm::dvec2> uvsOf(const tinygltf::Model&, const Texture&, const tinygltf::Primitive&,
                                            std::size_t count);

/// Vertex colours, linear; none: all are white.
/// @throws Error  (Kind::Input) if their accessor does not fit
[[nodiscard]] std::vector<glm::dvec4> vertexColors(const tinygltf::Model&, const tinygltf::Primitive&,
                                                   std::size_t count);

}  // namespace inkedge::gltf

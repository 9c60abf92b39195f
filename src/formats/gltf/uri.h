#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace inkedge::gltf {

[[nodiscard]] bool isDataUri(std::string_view uri) noexcept;

/// The bytes of "data:[media type];base64,...".
/// @throws Error  (Kind::Input) if it is not base64
[[nodiscard]] std::vector<std::uint8_t> decodeDataUri(std::string_view uri);

/// The file that a URI of a model names, with every link followed.
/// @throws Error  (Kind::Input) if the URI has a scheme, is malformed or absolute, names no regular file, or leads out
///                of the model's folder, be it by "..", percent-encoded or not, or by a link
[[nodiscard]] std::filesystem::path fileOfUri(const std::filesystem::path& model, std::string_view uri);

}  // namespace inkedge::gltf

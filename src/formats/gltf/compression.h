#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace inkedge::gltf {

/// Whether an extension compresses geometry: EXT_meshopt_compression or KHR_draco_mesh_compression.
[[nodiscard]] bool isCompression(std::string_view extension) noexcept;

/// Whether this build reads one of these.
[[nodiscard]] bool readsCompression(std::string_view extension) noexcept;

/// Whether a buffer only stands in for data compressed with EXT_meshopt_compression: nothing of it need be read.
[[nodiscard]] bool isFallback(const nlohmann::json& buffer);

/// Puts plain data in place of compressed data, in further buffers, bufferViews and accessors, and takes the extensions
/// out of bufferViews and primitives. What a decompressed accessor holds is exactly what its description says; whether
/// its elements fit their use is the reader's to check. Does nothing for extensions that this build does not read,
/// where the file has the data in plain, too.
/// @throws Error  (Kind::Input) if compressed data are damaged, are not what the document says, come to over
///                mostBytes in all, or are there alone and this build does not read them
void decompress(nlohmann::json& document, std::vector<std::vector<std::uint8_t>>& buffers, std::uint64_t mostBytes);

}  // namespace inkedge::gltf

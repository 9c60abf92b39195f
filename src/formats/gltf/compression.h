#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace inkedge::gltf {

/// Whether an extension compresses geometry: EXT_meshopt_compression or KHR_draco_mesh_compression.
[[nodiscard]] bool isCompression(std::string_view extension) noexcept;

/// Whether it is one of these and its module can be opened.
[[nodiscard]] bool readsCompression(std::string_view extension);

/// What to say after the name of one of these that is not read: "which this build does not read", and why.
[[nodiscard]] std::string whyUnread(std::string_view extension);

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

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace inkedge::gltf {

/// Whether an extension compresses geometry: KHR_meshopt_compression, EXT_meshopt_compression or
/// KHR_draco_mesh_compression.
[[nodiscard]] bool isCompression(std::string_view extension) noexcept;

/// Whether an extension compresses geometry and its module can be opened.
[[nodiscard]] bool readsCompression(std::string_view extension);

/// What a message says after the name of such an extension that is not read: "which this build does not read", and why.
[[nodiscard]] std::string whyUnread(std::string_view extension);

/// Marks the buffers without a uri that compressed bufferViews refer to as those that isFallback() finds: writers need
/// not mark them.
/// @param hasBinaryChunk  whether buffer 0 is that of a .glb
void markFallbacks(nlohmann::json& document, bool hasBinaryChunk);

/// Whether a buffer only stands for data that meshopt has compressed. Such a buffer need not be read.
[[nodiscard]] bool isFallback(const nlohmann::json& buffer);

/// Replaces compressed data by plain data, in further buffers, bufferViews and accessors, and removes the extensions
/// from bufferViews and primitives. A decompressed accessor holds exactly what its description says; the reader checks
/// whether its elements fit their use. Extensions that this build does not read are left alone if the file also has the
/// plain data.
/// @throws Error  (Kind::Input) if compressed data are damaged, are not what the document says, come to over
///                maxBytes in all, or have no plain form and this build does not read them
void decompress(nlohmann::json& document, std::vector<std::vector<std::uint8_t>>& buffers, std::uint64_t maxBytes);

}  // namespace inkedge::gltf

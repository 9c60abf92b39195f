#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <inkedge/settings.h>

#include "base/read_file.h"
#include "formats/gltf/materials.h"

namespace inkedge::gltf {

/// A glTF file and its buffers in memory. The JSON is made safe for a parser that trusts its input: it nests no deeper
/// than 500, holds only what geometry needs, no number stands as 12.0 where 12 is meant, integers fit 32 bits (larger
/// ones become the largest), buffer i's uri is the number i, and no geometry is compressed.
struct File {
    std::string json;
    std::vector<load::Bytes> buffers;  ///< each of the byteLength that the JSON gives
    std::vector<Material> materials;   ///< not in the JSON any more
    std::vector<Image> images;         ///< likewise; not read yet
    std::vector<std::string> warnings;
    std::vector<std::string> extensions;  ///< extensionsUsed
    std::uint64_t bytesLeft = 0;          ///< of limits.fileSize
};

/// Reads a .glb or .gltf file, told apart by content, with its buffers.
/// An extension that is used but not required, and not read, is warned of.
/// @throws Error  (Kind::Input) if a file is missing, unreadable, truncated or no glTF 2.0, lies outside the model's
///                folder, all of them together, or what compressed data come to, are over the limits, an extension is
///                required that is not read, or compressed data are damaged
[[nodiscard]] File readFile(const std::filesystem::path& model, const LoadLimits&);

/// What a uri of the model stands for: a data URI's bytes, or those of a file in the model's folder, whose size is
/// taken off bytesLeft.
/// @throws Error  (Kind::Input) as readFile()
[[nodiscard]] load::Bytes readUri(const std::filesystem::path& model, const std::string& uri, std::uint64_t& bytesLeft);

}  // namespace inkedge::gltf

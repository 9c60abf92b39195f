#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace inkedge::gltf {

/// A glTF file and its buffers in memory. The JSON is made safe for a parser that trusts its input: it nests no deeper
/// than 500, holds only what geometry needs, no number stands as 12.0 where 12 is meant, integers fit 32 bits (larger
/// ones become the largest), buffer i's uri is the number i, and no geometry is compressed.
struct File {
    std::string json;
    std::vector<std::vector<std::uint8_t>> buffers;  ///< each of the byteLength that the JSON gives
};

/// Reads a .glb or .gltf file, told apart by content, with its buffers.
/// @throws Error  (Kind::Input) if a file is missing, unreadable, truncated or no glTF 2.0, lies outside the model's
///                folder, all of them together are over 2 GiB, an extension is required that is not read, or compressed
///                data are damaged or come to over 1 GiB
[[nodiscard]] File readFile(const std::filesystem::path& model);

}  // namespace inkedge::gltf

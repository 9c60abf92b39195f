#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace inkedge::gltf {

/// A bufferView's data in EXT_meshopt_compression, as the file describes it, unchecked.
struct MeshoptView {
    std::uint64_t count = 0;   ///< elements
    std::uint64_t stride = 0;  ///< bytes an element takes once decompressed
    std::string mode;          ///< "ATTRIBUTES", "TRIANGLES" or "INDICES"
    std::string filter = "NONE";
};

/// Whether this build reads EXT_meshopt_compression.
[[nodiscard]] bool readsMeshopt() noexcept;

/// The count * stride bytes that the data stand for.
/// @param bytesLeft  the most that may come out, in bytes
/// @throws Error     (Kind::Input) if a parameter is not one that the extension allows, the result has over bytesLeft
///                   bytes, the data are damaged or cannot hold so much, or this build does not read them
[[nodiscard]] std::vector<std::uint8_t> decodeMeshopt(const MeshoptView&, std::span<const std::uint8_t> data,
                                                      std::uint64_t bytesLeft);

}  // namespace inkedge::gltf

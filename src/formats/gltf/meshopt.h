#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "modules/open_module.h"

namespace inkedge::gltf {

/// What the file says of a bufferView's data in KHR_meshopt_compression or EXT_meshopt_compression, unchecked.
struct MeshoptData {
    std::uint64_t count = 0;   ///< elements
    std::uint64_t stride = 0;  ///< bytes of a decompressed element
    std::string mode;          ///< "ATTRIBUTES", "TRIANGLES" or "INDICES"
    std::string filter = "NONE";
};

// The interface between the library and the meshoptimizer module.
struct MeshoptFunctions {
    /// Writes count * stride bytes. 0: they are decoded; -1: the first byte of data is not known; otherwise data are
    /// damaged.
    using Decode = int (*)(void* elements, std::size_t count, std::size_t stride, const unsigned char* data,
                           std::size_t size);
    using Filter = void (*)(void* elements, std::size_t count, std::size_t stride);

    Decode vertices;
    Decode triangles;
    Decode indices;
    Filter octahedral;
    Filter quaternion;
    Filter exponential;
};
inline constexpr modules::ModuleOf<MeshoptFunctions> meshoptModule{{.purpose = "meshopt compression",
                                                                    .file = "inkedge_meshopt.so",
                                                                    .symbol = "inkedge_meshopt_2",
                                                                    .library = "libmeshoptimizer",
                                                                    .option = "INKEDGE_MESHOPT",
                                                                    .remedy = "give a model that is not compressed"}};

/// Decompresses count * stride bytes.
/// @param bytesLeft  the maximum size of the result, in bytes
/// @throws Error     (Kind::Input) if a parameter is not one that the extensions allow, the result has over bytesLeft
///                   bytes, the data are damaged or cannot hold so much, or the module is missing
[[nodiscard]] std::vector<std::uint8_t> decodeMeshopt(const MeshoptData& view, std::span<const std::uint8_t> data,
                                                      std::uint64_t bytesLeft);

}  // namespace inkedge::gltf

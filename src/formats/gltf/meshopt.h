#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "modules/failure.h"
#include "modules/open_module.h"

namespace inkedge::gltf {

/// What the file says of a bufferView's data in EXT_meshopt_compression, unchecked.
struct MeshoptData {
    std::uint64_t count = 0;   ///< elements
    std::uint64_t stride = 0;  ///< bytes of a decompressed element
    std::string mode;          ///< "ATTRIBUTES", "TRIANGLES" or "INDICES"
    std::string filter = "NONE";
};

// The interface between the library and the meshoptimizer module.
struct DecodedMeshopt {
    std::vector<std::uint8_t> bytes;
    std::string failure;
};
struct MeshoptFunctions {
    DecodedMeshopt (*decode)(const MeshoptData&, std::span<const std::uint8_t> data, std::uint64_t bytesLeft);
};
inline constexpr ModuleOf<MeshoptFunctions> meshoptModule{{.purpose = "EXT_meshopt_compression",
                                                           .file = "inkedge_meshopt.so",
                                                           .symbol = "inkedge_meshopt_1",
                                                           .library = "libmeshoptimizer",
                                                           .option = "INKEDGE_MESHOPT",
                                                           .remedy = "give a model that is not compressed"}};

/// Decompresses count * stride bytes.
/// @param bytesLeft  the maximum size of the result, in bytes
/// @throws Error     (Kind::Input) if a parameter is not one that the extension allows, the result has over bytesLeft
///                   bytes, the data are damaged or cannot hold so much, or the module is missing
[[nodiscard]] inline std::vector<std::uint8_t> decodeMeshopt(const MeshoptData& view,
                                                             std::span<const std::uint8_t> data,
                                                             std::uint64_t bytesLeft) {
    constexpr Error::Kind kind = Error::Kind::Input;
    return expectNoFailure(functionsOf<meshoptModule>(kind).decode(view, data, bytesLeft), kind).bytes;
}

}  // namespace inkedge::gltf

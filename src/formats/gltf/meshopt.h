#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "modules/failure.h"
#include "modules/open_module.h"

namespace inkedge::gltf {

/// A bufferView's data in EXT_meshopt_compression, as the file describes it, unchecked.
struct MeshoptView {
    std::uint64_t count = 0;   ///< elements
    std::uint64_t stride = 0;  ///< bytes an element takes once decompressed
    std::string mode;          ///< "ATTRIBUTES", "TRIANGLES" or "INDICES"
    std::string filter = "NONE";
};

// What the library and the module of meshoptimizer say to each other.
struct DecodedMeshopt {
    std::vector<std::uint8_t> bytes;
    std::string failure;
};
struct MeshoptFunctions {
    DecodedMeshopt (*decode)(const MeshoptView&, std::span<const std::uint8_t> data, std::uint64_t bytesLeft);
};
inline constexpr ModuleOf<MeshoptFunctions> meshoptModule{{.purpose = "EXT_meshopt_compression",
                                                           .file = "inkedge_meshopt.so",
                                                           .symbol = "inkedge_meshopt_1",
                                                           .library = "libmeshoptimizer",
                                                           .option = "INKEDGE_MESHOPT",
                                                           .remedy = "give a model that is not compressed"}};

/// The count * stride bytes that the data stand for.
/// @param bytesLeft  the most that may come out, in bytes
/// @throws Error     (Kind::Input) if a parameter is not one that the extension allows, the result has over bytesLeft
///                   bytes, the data are damaged or cannot hold so much, or the module is missing
[[nodiscard]] inline std::vector<std::uint8_t> decodeMeshopt(const MeshoptView& view,
                                                             std::span<const std::uint8_t> data,
                                                             std::uint64_t bytesLeft) {
    constexpr Error::Kind kind = Error::Kind::Input;
    return expectNoFailure(functionsOf<meshoptModule>(kind).decode(view, data, bytesLeft), kind).bytes;
}

}  // namespace inkedge::gltf

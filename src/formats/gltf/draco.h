#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formats/gltf/accessor.h"
#include "modules/failure.h"
#include "modules/open_module.h"

namespace inkedge::gltf {

/// A mesh decoded from KHR_draco_mesh_compression.
struct DracoMesh {
    struct Attribute {
        std::uint64_t components = 0;  ///< an element
        Component component = Component::Float;
        std::vector<std::uint8_t> bytes;  ///< one element a vertex, tightly packed
    };
    std::uint64_t vertexCount = 0;
    std::vector<std::uint32_t> indices;  ///< three per triangle
    std::vector<Attribute> attributes;   ///< in the order asked for
};

/// What a primitive says about its compressed mesh.
struct DracoExpected {
    std::vector<std::uint32_t> attributes;       ///< the unique ids of those to read
    std::optional<std::uint64_t> triangleCount;  ///< none: any
};

// The interface between the library and the Draco module.
struct DecodedDraco {
    DracoMesh mesh;
    std::string failure;
};
struct DracoFunctions {
    DecodedDraco (*decode)(std::span<const std::uint8_t> data, const DracoExpected&, std::uint64_t bytesLeft);
};
inline constexpr modules::ModuleOf<DracoFunctions> dracoModule{{.purpose = "KHR_draco_mesh_compression",
                                                                .file = "inkedge_draco.so",
                                                                .symbol = "inkedge_draco_1",
                                                                .library = "libdraco",
                                                                .option = "INKEDGE_DRACO",
                                                                .remedy = "give a model that is not compressed"}};

/// @param bytesLeft  the maximum size of the result, in bytes
/// @throws Error     (Kind::Input) if the data are no Draco mesh of bitstream 2.2, are damaged, lack an attribute, are
///                   not as expected, hold over 2^24 triangles or over bytesLeft bytes, or the module is missing
[[nodiscard]] inline DracoMesh decodeDraco(std::span<const std::uint8_t> data, const DracoExpected& expected,
                                           std::uint64_t bytesLeft) {
    constexpr Error::Kind kind = Error::Kind::Input;
    return modules::expectNoFailure(modules::functionsOf<dracoModule>(kind).decode(data, expected, bytesLeft), kind)
        .mesh;
}

}  // namespace inkedge::gltf

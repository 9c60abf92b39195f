#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <inkedge/settings.h>

#include "base/read_file.h"
#include "formats/gltf/materials.h"
#include "formats/model_input.h"

namespace inkedge::gltf {

/// A glTF file and its buffers in memory. The JSON is made safe for a parser that trusts its input. It nests no deeper
/// than 500 and holds only what geometry needs. Whole numbers are written as 12, never 12.0, and fit 32 bits (larger
/// ones become the largest). The uri of buffer i is the number i. No geometry is compressed.
struct File {
    std::string json;
    std::vector<base::Bytes> buffers;          ///< each of the byteLength that the JSON gives
    std::vector<Material> materials;           ///< removed from the JSON
    std::vector<Image> images;                 ///< removed from the JSON; their pixels are not read yet
    std::vector<std::filesystem::path> named;  ///< its buffers' and images' files, as far as they are there
    std::vector<std::string> warnings;
    std::vector<std::string> extensions;  ///< extensionsUsed
    bool primitiveRestart = false;        ///< whether indices may hold restarts: KHR_ or EXT_mesh_primitive_restart
    std::uint64_t bytesLeft = 0;          ///< of limits.fileSize
};

/// Reads a .glb or .gltf file with its buffers; the content decides which of the two it is. An extension that is used
/// but not required, and not read, gives a warning.
/// @throws Error  (Kind::Input) if a file is missing, unreadable, truncated or no glTF 2.0, lies outside the model's
///                folder, all of them together, or what compressed data come to, are over the limits, an extension is
///                required that is not read, or compressed data are damaged
[[nodiscard]] File readFile(const formats::ModelInput&, const LoadLimits&);

/// The bytes of a uri of the model: of a data URI, or of a file in the model's folder, whose size is subtracted from
/// bytesLeft.
/// @throws Error  (Kind::Input) as readFile(), or if a model in memory names a file
[[nodiscard]] base::Bytes readUri(const formats::ModelInput&, const std::string& uri, std::uint64_t& bytesLeft);

}  // namespace inkedge::gltf

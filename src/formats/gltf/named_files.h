#pragma once

#include <filesystem>
#include <vector>

#include "formats/gltf/json.h"
#include "formats/model_input.h"

namespace inkedge::gltf {

/// The files of a document's buffers and images, read or not, with every link followed. Those that are not there, or
/// may not be read, are left out.
[[nodiscard]] std::vector<std::filesystem::path> namedFiles(const formats::ModelInput&, const Json& document);

}  // namespace inkedge::gltf

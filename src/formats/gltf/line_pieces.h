#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formats/gltf/triangles.h"

namespace inkedge::gltf {

/// The straight pieces of a primitive's lines, two indices each: glTF 2.0, section 3.7.2.1.
/// @param mode     one that draws lines
/// @param corners  the primitive's vertex indices in the order of the file; a last one of LINES without a second is not
///                 used
[[nodiscard]] std::vector<std::uint32_t> linePieces(Mode mode, std::span<const std::uint32_t> corners);

}  // namespace inkedge::gltf

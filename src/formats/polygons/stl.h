#pragma once

#include <cstdint>
#include <span>

#include "formats/polygons/polygon_file.h"

namespace inkedge::load {

/// Reads an STL file, binary or text. Facet normals are left out. A text that ends after a whole facet, and a binary
/// file whose header counts none or too many of the facets there, are read with a warning. O(n).
/// @throws Error  (Kind::Input) if the file is no STL, is truncated or has no facet, or if text is malformed; the
///                message then names the facet
[[nodiscard]] PolygonFile readStl(std::span<const std::uint8_t> bytes);

}  // namespace inkedge::load

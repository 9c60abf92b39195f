#pragma once

#include <cstdint>
#include <span>

#include "formats/polygons/polygon_file.h"

namespace inkedge::polygons {

/// Reads an STL file, binary or text. Facet normals are left out. There is a warning if a text ends after a whole
/// facet, and if the header of a binary file says no facets or more than there are. O(n).
/// @throws Error  (Kind::Input) if the file is no STL, is truncated, over the limit or has no facet, or if text is
///                malformed; the message then names the facet
/// @param maxElements  limits.vertices
[[nodiscard]] PolygonFile readStl(std::span<const std::uint8_t> bytes, std::uint64_t maxElements);

/// Refuses by its start and its size what readStl() would refuse: binary files that are truncated or over the limit.
/// @throws Error  (Kind::Input) as readStl()
void expectStlWithin(std::span<const std::uint8_t> start, std::uint64_t size, std::uint64_t maxElements);

}  // namespace inkedge::polygons

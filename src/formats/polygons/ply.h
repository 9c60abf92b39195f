#pragma once

#include <string_view>

#include "formats/polygons/format.h"
#include "formats/polygons/polygon_file.h"

namespace inkedge::polygons {

/// Reads a PLY file, text or binary; its elements may come in any order. Of vertices the positions, the normals and, if
/// they are needed, the texture coordinates are read; of faces and triangle strips the vertices, which may be out of
/// range. O(n).
/// @throws Error  (Kind::Input) if the file is no PLY, is truncated or over the limit, or its header or a number is
///                malformed
/// @param maxElements  limits.vertices
[[nodiscard]] PolygonFile readPly(std::string_view content, Coordinates, std::uint64_t maxElements);

/// Refuses by its header what readPly() would refuse: a file over the limit.
/// @param start    that of a file; nothing happens if it does not hold the whole header
/// @throws Error   (Kind::Input) as readPly()
void expectPlyWithin(std::string_view start, std::uint64_t maxElements);

}  // namespace inkedge::polygons

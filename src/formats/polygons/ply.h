#pragma once

#include <string_view>

#include "formats/polygons/format.h"
#include "formats/polygons/polygon_file.h"

namespace inkedge::polygons {

/// Reads a PLY file, text or binary; its elements may come in any order. Of vertices the positions, the normals and, if
/// they are needed, the texture coordinates are read; of faces and triangle strips the vertices, which may be out of
/// range. O(n).
/// @throws Error  (Kind::Input) if the file is no PLY, is truncated, or its header or a number is malformed
[[nodiscard]] PolygonFile readPly(std::string_view content, Coordinates coordinates = Coordinates::Skip);

}  // namespace inkedge::polygons

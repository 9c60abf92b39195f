#pragma once

#include <string_view>

#include "formats/polygons/format.h"
#include "formats/polygons/polygon_file.h"

namespace inkedge::polygons {

/// Reads an OBJ file. Corners that name the same v, vt and vn are one vertex; vertices are numbered in the order of
/// their first use. A face has normals if all its corners have them, and so for texture coordinates if they are needed.
/// Free-form curves and surfaces, and what does not change the shape, are left out. O(n).
/// @throws Error  (Kind::Input) if the file is no text, over the limit, holds no face, line or point, or a line with v,
///                vn, f, or vt if it is needed, is malformed; the message names the line
/// @param maxElements  limits.vertices
[[nodiscard]] PolygonFile readObj(std::string_view content, Coordinates, std::uint64_t maxElements);

}  // namespace inkedge::polygons

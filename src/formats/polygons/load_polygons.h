#pragma once

#include <filesystem>

#include <inkedge/scene.h>

#include "formats/polygons/format.h"

namespace inkedge {

/// Reads an OBJ, STL (binary or text) or PLY file, once. No other file is opened, be it named in the file or not.
///
/// The whole file is one mesh, named after the file and placed once, where it stands. Vertices are not joined by
/// position. Faces with more than three corners are cut into triangles as load::PolygonCutter does; triangles of PLY
/// with a repeated vertex are left out. Normals are those of OBJ and PLY, unit length, (0, 0, 0) where the file has
/// none; a file without any, and every STL file, as its normals are only its facets', has none. Materials are those of
/// OBJ, in the order in which faces use them, from 1. Texture coordinates are read if they are of use: of OBJ those of
/// faces all of whose corners have them, of PLY the vertices' own.
/// Text and doubles far from the origin keep their precision; where the file has only floats, a model that suffers from
/// that is warned of. Points and lines are left out with one warning. A file without triangles gives no meshes and no
/// instances.
///
/// @throws Error  (Kind::Input) if the file is missing, unreadable, over the limits, not of the format, truncated, or
///                has a position that is not finite or a face without its vertices; the message starts with the path as
///                given
/// Thread-safe.
[[nodiscard]] Scene::Data loadPolygons(const std::filesystem::path& file, load::PolygonFormat format,
                                       const LoadLimits& limits = {},
                                       load::Coordinates coordinates = load::Coordinates::Skip);

}  // namespace inkedge

#pragma once

#include <filesystem>

#include <inkedge/scene.h>

#include "formats/polygons/format.h"

namespace inkedge {

/// Whether this build reads these formats.
[[nodiscard]] bool readsPolygonFormats() noexcept;

/// Reads an OBJ, STL (binary or text) or PLY file. No other file is opened, be it named in the file or not.
///
/// The whole file is one mesh, named after the file and placed once, where it stands. Vertices are not joined. Faces
/// with more than three corners are cut into triangles as load::PolygonCutter does. Normals are those of OBJ and PLY,
/// unit length, (0, 0, 0) where the file has none; a file without any, and every STL file, as its normals are only its
/// facets', gives a mesh without normals. Materials are numbered in the order in which an OBJ file first uses
/// them, from 1. A face of an OBJ file has normals if all its corners have.
/// Texture coordinates are read if they are of use: of OBJ those of faces all of whose corners have them, of PLY the
/// vertices' own; v is turned over, as both have 0 at the bottom.
/// What lies far from the origin is read once more from near by, so that no precision is lost; where the file itself has
/// only floats, a model that suffers from that is warned of. Points and lines are left
/// out with one warning. A file without triangles gives no meshes and no instances.
///
/// @throws Error  (Kind::Input) if the file is missing, unreadable, over the limits, not of the format, truncated, has a
///                position that is not finite or a face without its vertices, or this build does not read the format; the message starts with the path as given
/// Thread-safe.
[[nodiscard]] Scene::Data loadAssimp(const std::filesystem::path& file, load::PolygonFormat format,
                                     const LoadLimits& limits = {},
                                     load::Coordinates coordinates = load::Coordinates::Skip);

}  // namespace inkedge

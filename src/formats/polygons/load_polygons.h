#pragma once

#include <inkedge/scene.h>

#include "formats/model_input.h"
#include "formats/polygons/format.h"

namespace inkedge::polygons {

/// Reads an OBJ, STL (binary or text) or PLY file, once. No other file is opened, be it named in the file or not.
///
/// The whole file is one mesh, named after the file, with one instance. Vertices are not joined by position. Faces with
/// more than three corners are cut into triangles by load::PolygonCutter; triangles of PLY with a repeated vertex are
/// left out. Normals are those of OBJ and PLY, unit length, (0, 0, 0) where the file has none. A file without normals
/// has none, and neither has an STL file, whose normals are only those of its facets. Materials are those of OBJ, in
/// the order in which faces use them, from 1. Texture coordinates are read if they are needed: of OBJ those of faces
/// all of whose corners have them, of PLY those of the vertices.
///
/// Text and doubles far from the origin keep their precision. If the file has floats that are too coarse so far from
/// the origin there is a warning. Lines are OBJ's l, edges of PLY and faces of two corners. Points are left out with
/// one warning. A file without triangles and lines gives no meshes and no instances.
///
/// @throws Error  (Kind::Input) if the file is missing, unreadable, over the limits, not of the format, truncated, or
///                has a position that is not finite or a face without its vertices; the message starts with the name as
///                given
/// Thread-safe.
[[nodiscard]] Scene::Data loadPolygons(const formats::ModelInput&, PolygonFormat format, const LoadLimits& limits = {},
                                       Coordinates coordinates = Coordinates::Skip);

}  // namespace inkedge::polygons

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "formats/polygons/format.h"

namespace inkedge::load {

/// What a PLY file says about its surface, fit for a reader that trusts its input.
struct PlyContent {
    /// The vertices' positions and normals, texture coordinates if they are of use, and the faces' indices, as many as the header and the lists say, in the
    /// encoding of the file, text with one element a line. Indices may be out of range.
    std::vector<std::uint8_t> bytes;
    bool finerThanFloat = false;  ///< its coordinates are text or doubles
};

/// Reads and checks the whole file. Coordinates finer than floats keep their precision far from the world's origin if an
/// origin near them is taken off first. O(n).
/// @throws Error  (Kind::Input) if the file is no PLY, is truncated, or its header or a number is malformed
[[nodiscard]] PlyContent safePly(std::string_view content, const glm::dvec3& origin = glm::dvec3{0.0},
                                 Coordinates coordinates = Coordinates::Skip);

}  // namespace inkedge::load

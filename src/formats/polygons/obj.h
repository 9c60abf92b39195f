#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "formats/polygons/format.h"

namespace inkedge::load {

/// What an OBJ file says about its surface, fit for a reader that trusts its input.
struct ObjContent {
    std::vector<std::uint8_t> text;            ///< only v, vn, f, and vt if it is of use; every index is in range
    std::vector<std::uint32_t> faceMaterials;  ///< one a face: 1 + its number in the order of first use, 0: none
    std::uint64_t points = 0;                  ///< left out
    std::uint64_t lines = 0;                   ///< left out
};

/// Reads and checks every line. What stands far from the origin keeps its precision if an origin near it is taken off all
/// positions before they become floats. Free-form curves and surfaces and what does not bear on the shape are left out. O(n).
/// @throws Error  (Kind::Input) if the file is no text, or a line with v, vn, f, or vt if it is of use, is not as it should be; the message
///                names the line
[[nodiscard]] ObjContent checkedObj(std::string_view content, const glm::dvec3& origin = glm::dvec3{0.0},
                                    Coordinates coordinates = Coordinates::Skip);

}  // namespace inkedge::load

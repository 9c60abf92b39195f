#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace inkedge {

/// Vertices that stand at one place, whatever else sets them apart, get one number.
struct Weld {
    std::vector<std::uint32_t> point;  ///< one a position: the number of its place, 0..pointCount-1 in order of appearance
    std::uint32_t pointCount = 0;
};

/// Welds positions that are exactly equal (-0 equals 0). O(n).
[[nodiscard]] Weld weldByPosition(std::span<const glm::vec3> positions);

}  // namespace inkedge

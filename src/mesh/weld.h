#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace inkedge {

/// Vertices that stand at one place, whatever else sets them apart, get one number.
struct Weld {
    std::vector<std::uint32_t>
        point;  ///< one a position: the number of its place, 0..pointCount-1 in order of appearance
    std::uint32_t pointCount = 0;
    double tolerance = 0.0;  ///< how far apart two positions of one place may be
};

/// Positions that differ by no more than this share of the diagonal of their box are one place. It is about the
/// rounding that a float leaves in a coordinate: exporters that compute a shared corner twice are off by so much.
inline constexpr double weldTolerance = 5e-7;

/// weldTolerance of the positions' box, in their unit.
[[nodiscard]] double weldToleranceOf(std::span<const glm::vec3> positions);

/// Welds positions that are equal (-0 equals 0) or within weldTolerance of one already met. O(n).
[[nodiscard]] Weld weldByPosition(std::span<const glm::vec3> positions);

}  // namespace inkedge

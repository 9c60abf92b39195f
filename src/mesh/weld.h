#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace inkedge::mesh {

/// Numbers of points: vertices at one position have one number, whatever else they differ in.
struct Weld {
    std::vector<std::uint32_t>
        point;  ///< one per position: the number of its point, 0..pointCount-1 in order of appearance
    std::uint32_t pointCount = 0;
};

/// Positions that differ by no more than this share of the diagonal of their box are one point. It is about the
/// rounding of a float coordinate, by which the results of exporters that compute a shared corner twice differ.
inline constexpr double weldTolerance = 5e-7;

/// weldTolerance of the positions' box, in their unit.
[[nodiscard]] double weldToleranceOf(std::span<const glm::vec3> positions);

/// Welds positions that are equal (-0 equals 0) or within weldTolerance of one already met. O(n).
[[nodiscard]] Weld weldByPosition(std::span<const glm::vec3> positions);

}  // namespace inkedge::mesh

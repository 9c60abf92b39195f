#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge::curves {

/// A line through some of the points of another line: no point of the one is further than tolerance from the other.
/// Points that are not finite are left out; a line of fewer than three other points keeps them.
/// @param tolerance  pixels, 0 or more; 0 drops only points on the straight line between their neighbours
/// Pure, thread-safe; O(n log n) on most lines of n points, O(n) times a constant on the worst.
/// Source: Douglas and Peucker 1973, distances to chords, not to their lines.
[[nodiscard]] Line simplify(const Line&, double tolerance);

/// Marks in kept which of the points between the first and the last, that are kept, a simplified polyline needs: no
/// point of it is further than tolerance from the polyline through those that are marked. points and kept have one
/// size; tolerance is counted as the points are. Pure, thread-safe; O(n log n) on most polylines, O(n^2) on the worst.
void keepBetween(std::span<const glm::dvec2> points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& kept);

}  // namespace inkedge::curves

#pragma once

#include <inkedge/lines.h>

namespace inkedge::curves {

/// A line through some of the points of another line: no point of the one is further than tolerance from the other.
/// Points that are not finite are left out; a line of fewer than three other points keeps them.
/// @param tolerance  pixels, 0 or more; 0 drops only points on the straight line between their neighbours
/// Pure, thread-safe; O(n log n) on most lines of n points, O(n) times a constant on the worst.
/// Source: Douglas and Peucker 1973, distances to chords, not to their lines.
[[nodiscard]] Line simplify(const Line&, double tolerance);

}  // namespace inkedge::curves

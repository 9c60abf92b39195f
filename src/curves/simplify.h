#pragma once

#include <inkedge/lines.h>

namespace inkedge {

/// A line through some of the points of another: no place of the one is further than tolerance from the other. What is
/// not finite is left out; a line of fewer than two other points keeps those.
/// @param tolerance  pixels, 0 or more; 0 drops only points on the way between their neighbours
/// Pure, thread-safe; O(n log n) on most lines of n points, O(n) times a constant on the worst.
/// Source: Douglas and Peucker 1973, distances to chords, not to their lines.
[[nodiscard]] Line simplify(const Line&, double tolerance);

}  // namespace inkedge

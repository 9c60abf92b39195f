#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge {

/// A cubic Bezier curve: where it starts, its two control points, where it ends.
using Bezier = std::array<glm::dvec2, 4>;

/// Curves through a line, each beginning where the one before ends; those of a closed line end where they begin. No
/// place of them is further than tolerance from the line, and none of the line further from them. They meet smoothly
/// but where the line turns more sharply than the tolerance explains; there they meet in a corner of the line. A
/// straight part becomes one straight curve with its control points on it.
/// @param tolerance  pixels, over 0
/// @return  nothing if the line has fewer than two finite points
/// Pure, thread-safe; O(n log n) on most lines.
/// Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems 1990; but each curve goes
/// as far as it can instead of halving what does not fit.
[[nodiscard]] std::vector<Bezier> fitBeziers(const Line&, double tolerance);

/// The point of a curve at t, 0 to 1.
[[nodiscard]] glm::dvec2 pointAt(const Bezier&, double t) noexcept;

}  // namespace inkedge

#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge::curves {

/// A cubic Bezier curve: its start, its two control points, its end.
using Bezier = std::array<glm::dvec2, 4>;

/// Curves through a line. Each curve begins where the one before ends; the curves of a closed line end where they
/// began. No point of the curves is further than tolerance from the line, and no point of the line further from the
/// curves. Curves meet smoothly, except in corners of the line: where it turns more sharply than the tolerance
/// explains. A straight part becomes one straight curve with its control points on it.
/// @param tolerance  pixels, over 0
/// @return  nothing if the line has fewer than two finite points
/// Pure, thread-safe; O(n log n) on most lines.
/// Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems 1990; but each curve goes
/// as far as it can instead of halving what does not fit.
[[nodiscard]] std::vector<Bezier> fitBeziers(const Line&, double tolerance);

/// The point of a curve at t, 0 to 1.
[[nodiscard]] glm::dvec2 pointAt(const Bezier&, double t) noexcept;

}  // namespace inkedge::curves

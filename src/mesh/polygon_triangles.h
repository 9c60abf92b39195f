#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge {

/// A closed loop of corners.
using Polygon = std::vector<glm::dvec2>;

/// Anticlockwise (x to the right, y up).
using PolygonTriangle = std::array<glm::dvec2, 3>;

/// The triangles of a convex polygon, whichever way it runs.
[[nodiscard]] std::vector<PolygonTriangle> convexTriangles(const Polygon&);

/// What loops go around, as loops that neither cross nor run along each other: an area's border anticlockwise, a hole's
/// clockwise.
/// @param loops  any: a place belongs to the area if they go around it, whichever way they do
/// @throws Error (Kind::Input) if libGLU cannot be loaded or gives up
[[nodiscard]] std::vector<Polygon> untangled(std::span<const Polygon> loops);

/// The triangles of a polygon's part within an area. Together they have the corners of that part, and no others.
/// @param polygon  does not cross itself
/// @param area     as untangled() gives it
/// @throws Error   (Kind::Input) as untangled()
[[nodiscard]] std::vector<PolygonTriangle> trianglesWithin(const Polygon& polygon, std::span<const Polygon> area);

}  // namespace inkedge

#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge::mesh {

/// A closed loop of corners.
using Polygon = std::vector<glm::dvec2>;

/// Anticlockwise (x to the right, y up).
using PolygonTriangle = std::array<glm::dvec2, 3>;

/// The triangles of a convex polygon, whichever way it runs.
[[nodiscard]] std::vector<PolygonTriangle> convexTriangles(const Polygon&);

/// The area that loops enclose, as loops that neither cross nor run along each other: the border of an area
/// anticlockwise, that of a hole clockwise.
/// @param loops  any: a point belongs to the area if the loops' winding number there is not 0
/// @throws Error (Kind::Input) if libGLU cannot be loaded or gives up
[[nodiscard]] std::vector<Polygon> untangled(std::span<const Polygon> loops);

/// The triangles of the part of a polygon that lies within an area. Their corners are those of that part, and no
/// others.
/// @param polygon  does not cross itself
/// @param area     as untangled() gives it
/// @throws Error   (Kind::Input) as untangled()
[[nodiscard]] std::vector<PolygonTriangle> trianglesWithin(const Polygon& polygon, std::span<const Polygon> area);

}  // namespace inkedge::mesh

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace inkedge::mesh {

/// A part of a triangle: its corners in barycentric coordinates of the triangle.
using TrianglePiece = std::array<glm::dvec3, 3>;

/// Into how many steps of equal length each edge of a triangle is parted, from corner k to the next: powers of two.
using EdgeSteps = std::array<std::uint32_t, 3>;

/// Opacity less threshold at a point of a triangle in barycentric coordinates; finite.
using Excess = std::function<double(const glm::dvec3&)>;

/// The part of a triangle where the excess is at least 0, wound as the triangle is. The excess is sampled at the steps
/// of the edges, within at as many as the edge with most, and taken for linear between them; the outline within is
/// simplified to a fifth of a step. Two triangles that agree on the steps and the excess along an edge are cut at the
/// same points of it.
/// @throws Error  (Kind::Input) if the outline has over 2^20 corners, or as trianglesWithin()
[[nodiscard]] std::vector<TrianglePiece> opaquePart(const EdgeSteps&, const Excess&);

}  // namespace inkedge::mesh

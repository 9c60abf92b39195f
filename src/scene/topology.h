#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace inkedge {

/// Marks a half-edge without a twin.
inline constexpr std::uint32_t noHalfEdge = ~0U;

/// For every half-edge the other one of its edge, where exactly two half-edges share the edge; else noHalfEdge.
///
/// Half-edge 3t + k of triangle t runs from its corner k to its corner (k + 1) % 3. Two half-edges share an edge if they
/// join the same two points, in either direction.
/// @param corners  three points a triangle, each below pointCount
/// O(n) in the number of triangles, but for points with very many edges.
[[nodiscard]] std::vector<std::uint32_t> twinHalfEdges(std::span<const std::uint32_t> corners, std::uint32_t pointCount);

/// The next half-edge of the same triangle; also: the corner where half-edge h ends.
[[nodiscard]] constexpr std::uint32_t nextHalfEdge(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }

}  // namespace inkedge

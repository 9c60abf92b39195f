#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

namespace inkedge {

/// Stands for the twin of a half-edge that has none: the surface's border.
inline constexpr std::uint32_t noHalfEdge = ~0U;
/// Stands for the twin of a half-edge whose edge three or more triangles share.
inline constexpr std::uint32_t manyHalfEdges = ~0U - 1;

[[nodiscard]] constexpr bool isHalfEdge(std::uint32_t twin) noexcept { return twin < manyHalfEdges; }

/// The next half-edge of the same triangle; also: the corner where half-edge h ends.
[[nodiscard]] constexpr std::uint32_t nextHalfEdge(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }

/// How the triangles of a mesh hang together once vertices at one place are one point.
///
/// Half-edge 3t + k of triangle t runs from its corner k to its corner (k + 1) % 3.
struct MeshTopology {
    std::vector<std::uint32_t> points;  ///< one a corner: its point, 0..pointCount-1
    std::uint32_t pointCount = 0;
    std::vector<std::uint32_t> originals;  ///< one a triangle: the first that has its three points; most often itself
    std::vector<std::uint32_t> twins;      ///< one a half-edge: the other of its edge, noHalfEdge or manyHalfEdges
    std::vector<bool> creases;             ///< one a half-edge: whether its edge is a crease; it has a twin then
    std::vector<glm::dvec3> faceNormals;  ///< one a triangle, unit, by winding; 0 where it is too thin; none in a Scene
    std::vector<std::uint32_t> patches;   ///< one a triangle: 0..patchCount-1
    std::uint32_t patchCount = 0;
};

/// A triangle whose least height is under this many weld tolerances has no normal worth the name: the rounding of its
/// corners turns it by more than half the usual crease angle.
inline constexpr double leastHeight = 4.0;

/// Fills points, originals, twins and faceNormals. Triangles that repeat an earlier one, whatever their winding, and
/// those with two corners at one point take no part in edges. O(n) but for points with very many edges.
[[nodiscard]] MeshTopology buildTopology(const Mesh&);

/// MeshTopology::faceNormals, made anew: a Scene does not keep them.
[[nodiscard]] std::vector<glm::dvec3> makeFaceNormals(const Mesh&);

/// Two faces that share an edge bend by this much there if cos(bend) is the result; either may be wound against the
/// other.
[[nodiscard]] double bendCosine(const MeshTopology&, std::uint32_t halfEdge, std::uint32_t twin);

/// Turns a triangle over: its second and third corner change places.
/// @param first  its first index's place
void turnOver(Mesh&, std::size_t first);

/// Whether the edge between two triangles lies within a polygon of the file.
[[nodiscard]] inline bool isInner(const Mesh& mesh, std::uint32_t halfEdge, std::uint32_t twin) {
    return !mesh.edges.empty() && mesh.edges[halfEdge].has(EdgeKind::Inner) && mesh.edges[twin].has(EdgeKind::Inner);
}

/// Whether an edge, or the same edge of the triangle beyond it if there is one, is of a kind.
[[nodiscard]] inline bool isOfKind(const Mesh& mesh, std::uint32_t halfEdge, std::uint32_t twin, EdgeKind kind) {
    return !mesh.edges.empty() && (mesh.edges[halfEdge].has(kind) || (isHalfEdge(twin) && mesh.edges[twin].has(kind)));
}

/// Whether the file says that the surface goes on across the edge between two triangles, however they bend there.
[[nodiscard]] inline bool isSmoothByKind(const Mesh& mesh, std::uint32_t halfEdge, std::uint32_t twin) {
    return isInner(mesh, halfEdge, twin) || isOfKind(mesh, halfEdge, twin, EdgeKind::Tangent) ||
           isOfKind(mesh, halfEdge, twin, EdgeKind::Seam);
}

/// Fills creases and patches: the faces that hang together across edges that are no creases. A crease bends by more
/// than the angle, is EdgeKind::Sharp, or its two faces' normals are split by more than that at both ends; edges that
/// are smooth by their kind are none. The mesh has all its normals. O(n).
void buildPatches(const Mesh&, double creaseAngle, MeshTopology&);

}  // namespace inkedge

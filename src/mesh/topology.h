#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

namespace inkedge::mesh {

/// Stands for the twin of a half-edge that has none: the surface's border.
inline constexpr std::uint32_t noHalfEdge = ~0U;
/// Stands for the twin of a half-edge whose edge three or more triangles share.
inline constexpr std::uint32_t manyHalfEdges = ~0U - 1;

[[nodiscard]] constexpr bool isHalfEdge(std::uint32_t twin) noexcept { return twin < manyHalfEdges; }

/// The next half-edge of the same triangle; also: the corner where half-edge h ends.
[[nodiscard]] constexpr std::uint32_t nextHalfEdge(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }

/// How the triangles of a mesh are connected once vertices at one position are one point.
///
/// Half-edge 3t + k of triangle t runs from its corner k to its corner (k + 1) % 3.
struct MeshTopology {
    std::vector<std::uint32_t> points;  ///< one per corner: its point, 0..pointCount-1
    std::uint32_t pointCount = 0;
    std::vector<std::uint32_t> originals;  ///< one per triangle: the first with the same three points; usually itself
    std::vector<std::uint32_t> twins;      ///< one per half-edge: the other of its edge, noHalfEdge or manyHalfEdges
    std::vector<bool> creases;             ///< one per half-edge: whether its edge, which then has a twin, is a crease
    std::vector<glm::dvec3>
        faceNormals;  ///< one per triangle, unit, by winding; 0 where it is too thin; none in a Scene
    std::vector<std::uint32_t> patches;  ///< one per triangle: 0..patchCount-1
    std::uint32_t patchCount = 0;
};

/// A triangle whose smallest height is under this many weld tolerances has no reliable normal: the rounding of its
/// corners turns the normal by more than half the usual crease angle.
inline constexpr double minHeight = 4.0;

/// Fills points, originals, twins and faceNormals. Triangles that repeat an earlier one, whatever their winding, and
/// triangles with two corners at one point have no edges. O(n), except for points with very many edges.
[[nodiscard]] MeshTopology buildTopology(const Mesh&);

/// MeshTopology::faceNormals, computed again: a Scene does not keep them.
[[nodiscard]] std::vector<glm::dvec3> makeFaceNormals(const Mesh&);

/// The cosine of the angle between the normals of two faces that share an edge, as if both were wound alike.
[[nodiscard]] double bendCosine(const MeshTopology&, std::uint32_t halfEdge, std::uint32_t twin);

/// Turns a triangle over: swaps its second and its third corner.
/// @param first  where the triangle begins in Mesh::indices
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

/// Fills creases and patches. An edge is a crease if its faces bend by more than the crease angle, if it is
/// EdgeKind::Sharp, or if its faces' vertex normals differ by more than that angle at both ends; but not if it is
/// smooth by its kind. A patch is a set of faces that are connected across edges that are no creases. The mesh must
/// have all its normals. O(n).
void buildPatches(const Mesh&, double creaseAngle, MeshTopology&);

}  // namespace inkedge::mesh

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

/// The half-edge before it in the same triangle; also: the corner opposite half-edge h.
[[nodiscard]] constexpr std::uint32_t previousHalfEdge(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }

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
        faceNormals;  ///< one per triangle, unit, by winding; 0 where it is too thin or a fold; none in a Scene
    std::vector<std::uint32_t> patches;   ///< one per triangle: 0..patchCount()-1
    std::vector<std::uint32_t> surfaces;  ///< one per patch: the first patch of the same surface
    /// The least bend of a crease that ends within a surface, as its cosine; -1: there is none.
    double innerCreaseCosine = -1.0;

    [[nodiscard]] std::uint32_t patchCount() const { return static_cast<std::uint32_t>(surfaces.size()); }
    [[nodiscard]] std::uint32_t surfaceOf(std::uint32_t triangle) const { return surfaces[patches[triangle]]; }
};

/// A triangle whose smallest height is under this many weld tolerances has no reliable normal: the rounding of its
/// corners turns the normal by more than half the usual crease angle.
inline constexpr double minHeight = 4.0;

/// Of the diagonal of a mesh's box: the height up to which a triangle that is folded over both its neighbours is a fold
/// of rounding, a tenth of a pixel of a model framed at 1024 pixels. Rounding to 14 bits turns triangles over whose
/// corners lie nearly on a line.
inline constexpr double maxFoldHeight = 1e-4;

/// Fills points, originals, twins and faceNormals. Triangles that repeat an earlier one, whatever their winding, and
/// triangles with two corners at one point have no edges. O(n), except for points with very many edges.
[[nodiscard]] MeshTopology buildTopology(const Mesh&);

/// MeshTopology::faceNormals, computed again: a Scene does not keep them. O(n).
[[nodiscard]] std::vector<glm::dvec3> makeFaceNormals(const Mesh&, const MeshTopology&);

/// The same of triangles by themselves: 0 only where one is too thin. O(n).
[[nodiscard]] std::vector<glm::dvec3> normalsOfTriangles(const Mesh&);

/// Whether a triangle is thick enough to have a normal.
[[nodiscard]] inline bool hasNormal(const MeshTopology& topology, std::uint32_t t) {
    return topology.faceNormals[t] != glm::dvec3{0.0};
}

/// The twin's corners at the start and at the end of a half-edge.
struct TwinEnds {
    std::uint32_t atStart;
    std::uint32_t atEnd;
};

[[nodiscard]] inline TwinEnds endsOfTwin(const MeshTopology& topology, std::uint32_t halfEdge, std::uint32_t twin) {
    const bool opposite = topology.points[halfEdge] != topology.points[twin];
    return opposite ? TwinEnds{nextHalfEdge(twin), twin} : TwinEnds{twin, nextHalfEdge(twin)};
}

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

/// Fills patches and surfaces. A surface is a set of faces that are connected across edges that are no creases; a patch
/// is one of the same that bend by no more than the crease angle there, which is less where an author's normals make
/// the edge smooth. Faces too thin to have a normal only connect their neighbours, if these bend by no more than the
/// crease angle; what they keep apart becomes a crease, too. O(n).
/// @param topology  with its creases
void buildPatches(double creaseAngle, MeshTopology& topology);

}  // namespace inkedge::mesh

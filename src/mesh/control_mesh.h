#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge::mesh {

enum class SubdivisionScheme {
    Loop,          ///< of triangles
    CatmullClark,  ///< of polygons
};

/// The polygons that a smooth surface starts from. The vertices are the mesh's points, welded by position. The faces
/// around a point are connected by edges that exactly two faces share, wound alike; where the faces fall into several
/// connected groups each group has a vertex of its own, so that the surface is a manifold.
struct ControlMesh {
    SubdivisionScheme scheme = SubdivisionScheme::Loop;
    std::vector<glm::dvec3> positions;        ///< one per vertex: mesh space, less the mesh's origin
    std::vector<std::int32_t> faceSizes;      ///< one per face: its corners, at least three; all three under Loop
    std::vector<std::int32_t> corners;        ///< into vertices, face after face
    std::vector<glm::vec2> coordinates;       ///< one per corner: Mesh::textureCoordinates there; or none
    std::vector<VertexPaint> paint;           ///< one per corner: Mesh::paint there; or none
    std::vector<EdgeKinds> edges;             ///< one per corner: kinds of the edge from it to the next; or none
    std::vector<std::int32_t> sharpEdges;     ///< two vertices each: creases. Borders are always sharp
    std::vector<std::int32_t> sharpVertices;  ///< vertices that stay where they are
    /// One per face: the first triangle of the mesh that is part of it.
    std::vector<std::uint32_t> firstTriangles;
    /// One per triangle of the mesh: the face that the triangle is a part of. noFace: the triangle repeats another or
    /// has collapsed.
    std::vector<std::uint32_t> faces;
};
inline constexpr std::uint32_t noFace = ~0U;

/// Puts the polygons of the file together again (EdgeKind::Inner), for Catmull-Clark; a mesh without polygons is for
/// Loop. Sharp edges are the topology's creases, edges of more than two faces, and edges of two faces wound against
/// each other. Sharp vertices are the corners of borders, where one face ends or two triangles that together are at
/// most square, and points whose groups of faces would come apart.
/// @param topology  with its creases
/// @throws Error    (Kind::Input) if a point has 65,000 faces or more
/// O(n log n).
[[nodiscard]] ControlMesh controlMesh(const Mesh&, const MeshTopology& topology);

/// Some faces of a control mesh, with their vertices renumbered. Edges towards faces that were not chosen become
/// borders.
/// @param chosen  faces, ascending
/// @return        without faces, coordinates, paint and kinds of edges; firstTriangles as they were
[[nodiscard]] ControlMesh subsetOf(const ControlMesh&, const std::vector<std::uint32_t>& chosen);

/// The number of vertices and indices after so many levels of refinement, not counting vertices that creases split.
[[nodiscard]] double refinedElements(const ControlMesh&, int levels);

}  // namespace inkedge::mesh

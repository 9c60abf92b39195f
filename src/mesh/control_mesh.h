#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

#include "mesh/topology.h"

namespace inkedge {

enum class SubdivisionScheme {
    Loop,          ///< of triangles
    CatmullClark,  ///< of polygons
};

/// The polygons that a smooth surface starts from. Its vertices are the mesh's points, welded by position; where the
/// faces around a point do not hang together by edges that just two of them share, wound alike, each part has a vertex
/// of its own, so that the surface is a manifold.
struct ControlMesh {
    SubdivisionScheme scheme = SubdivisionScheme::Loop;
    std::vector<glm::dvec3> positions;        ///< one a vertex: mesh space, less the mesh's origin
    std::vector<std::int32_t> faceSizes;      ///< one a face: its corners, at least three; all three under Loop
    std::vector<std::int32_t> corners;        ///< into vertices, face after face
    std::vector<glm::vec2> coordinates;       ///< one a corner: Mesh::textureCoordinates there; or none
    std::vector<VertexPaint> paint;           ///< one a corner: Mesh::paint there; or none
    std::vector<EdgeKinds> edges;             ///< one a corner: what the edge from it to the next is; or none
    std::vector<std::int32_t> sharpEdges;     ///< two vertices each: creases. Borders are sharp anyway
    std::vector<std::int32_t> sharpVertices;  ///< corners that stay where they are
    /// One a face: the first triangle of the mesh that is part of it.
    std::vector<std::uint32_t> firstTriangles;
    /// One a triangle of the mesh: the face that it is part of, or noFace: it repeats another or has collapsed.
    std::vector<std::uint32_t> faces;
};
inline constexpr std::uint32_t noFace = ~0U;

/// Puts the polygons of the file together again (EdgeKind::Inner), for Catmull-Clark; a mesh without any is for Loop.
/// Sharp edges are the topology's creases, and those that faces wound against each other or more than two faces share.
/// Sharp vertices are a border's corners, where one face ends, or two triangles that together are at most square, and
/// points whose parts would come apart.
/// @param topology  with its creases
/// @throws Error    (Kind::Input) if a point has 65,000 faces or more
/// O(n log n).
[[nodiscard]] ControlMesh controlMesh(const Mesh&, const MeshTopology& topology);

/// Some faces of a control mesh, with their vertices renumbered. What lay at their borders is border now.
/// @param chosen  faces, ascending
/// @return        without faces, coordinates, paint and kinds of edges; firstTriangles as they were
[[nodiscard]] ControlMesh partOf(const ControlMesh&, const std::vector<std::uint32_t>& chosen);

/// Vertices and indices of the triangles that so many levels of refinement make, but for vertices that creases split.
[[nodiscard]] double refinedElements(const ControlMesh&, int levels);

}  // namespace inkedge

#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge::lines {

/// The edges of a mesh, sorted by the lines that they may be, as arrays. Half-edges are those of MeshTopology.
///
/// Faces that repeat another, and faces collapsed to a line, are left out. A face too thin to have a normal counts as a
/// part of the face beside its longest shared edge.
struct MeshEdges {
    /// Edges that two faces share. If one face is front-facing and the other is not the edge is a contour.
    struct Shared {
        std::vector<std::uint32_t> faces;      ///< two per edge; the half-edge of the first face names the edge
        std::vector<std::uint32_t> halfEdges;  ///< one per edge: of the first face
        std::vector<std::uint8_t> against;     ///< one per edge: 1 if the faces are wound against each other, else 0
    } shared;
    std::vector<std::uint32_t> creases;   ///< into shared, ascending
    std::vector<std::uint32_t> marked;    ///< into shared, ascending: edges that the file marks and that are no creases
    std::vector<std::uint32_t> tangents;  ///< into shared, ascending: EdgeKind::Tangent, and neither crease nor marked
    std::vector<std::uint32_t> thinBorders;  ///< half-edges: borders of faces without a normal
    /// Half-edges of edges that three or more faces share: those of one edge follow each other.
    std::vector<std::uint32_t> many;
    std::vector<std::uint32_t> manyBegins;  ///< into many: where each such edge begins, and the end of the last one

    std::vector<glm::dvec3> faceNormals;  ///< as MeshTopology::faceNormals
    /// One per face: the largest sine of the angle between the face and a view of it that may be 0, for positions are
    /// known to six digits only. Below 0: the face has no normal.
    std::vector<float> edgeOnSines;
    /// One per position: the largest of those of its faces, for its normal is made of theirs.
    std::vector<float> normalSines;

    std::vector<std::int8_t> closed;  ///< as componentOrientations() gives them
};

/// Whether the file marks a half-edge, or its twin.
[[nodiscard]] bool isMarked(const Mesh&, const mesh::MeshTopology&, std::uint32_t halfEdge);

/// Whether a shared edge is a crease, or its faces are shaded with different normals.
[[nodiscard]] bool isSplit(const Mesh&, const mesh::MeshTopology&, const MeshEdges&, std::uint32_t edge);

/// @param creaseAngle  degrees
/// O(n).
[[nodiscard]] MeshEdges findEdges(const Mesh&, const mesh::MeshTopology&, double creaseAngle);

}  // namespace inkedge::lines

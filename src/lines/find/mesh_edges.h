#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge::lines {

/// The edges of a mesh by what lines they may be, as arrays. Half-edges are those of MeshTopology.
///
/// Faces that repeat another and those collapsed to a line take no part. A face too thin to have a normal counts as a
/// part of the one beside its longest shared edge.
struct MeshEdges {
    /// Edges that two faces share: where one face is front-facing and the other is not, the edge is a silhouette.
    struct Shared {
        std::vector<std::uint32_t> faces;      ///< two an edge; the first one's half-edge names the edge
        std::vector<std::uint32_t> halfEdges;  ///< one an edge: of the first face
        std::vector<std::uint8_t> against;     ///< one an edge: 1 if the faces are wound against each other, else 0
        std::vector<std::uint8_t>
            split;  ///< one an edge: 1 if it is a crease or the faces are shaded with different normals
    } shared;
    std::vector<std::uint32_t> creases;      ///< into shared, ascending
    std::vector<std::uint32_t> marked;       ///< likewise: those that the file marks and that are no creases
    std::vector<std::uint32_t> thinBorders;  ///< half-edges: borders of faces without a normal
    /// Half-edges of edges that three or more faces share: those of one edge follow each other.
    std::vector<std::uint32_t> many;
    std::vector<std::uint32_t> manyBegins;  ///< where each such edge begins in many; and the end of the last

    std::vector<glm::dvec3> faceNormals;  ///< as MeshTopology::faceNormals

    std::vector<std::int8_t> closed;  ///< as componentOrientations() gives them
};

/// Whether the file marks a half-edge, or its twin.
[[nodiscard]] bool isMarked(const Mesh&, const MeshTopology&, std::uint32_t halfEdge);

/// @param creaseAngle  degrees
/// O(n).
[[nodiscard]] MeshEdges findEdges(const Mesh&, const MeshTopology&, double creaseAngle);

}  // namespace inkedge::lines

#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <inkedge/edge_kinds.h>

#include "formats/cad/occt_faces.h"

namespace inkedge::cad {

/// What the edges of triangles are: within a face of the file EdgeKind::Inner where it is plane and EdgeKind::Seam
/// elsewhere; between two of them, piece by piece, EdgeKind::Sharp where the normals of the surfaces differ, and
/// EdgeKind::Tangent where only their curvatures do. Where these agree, too, it is one surface: EdgeKind::Seam, as
/// where a face meets itself. EdgeKind::Free: no other face shares it.
class EdgeTable {
public:
    /// @param faces  of one part
    explicit EdgeTable(const std::vector<MeshedFace>& faces);

    /// The kinds of an edge of a triangle, as bits of EdgeKind.
    /// @param face  into the faces; a, b: nodes of it
    [[nodiscard]] std::uint8_t kindOf(std::size_t face, std::uint32_t a, std::uint32_t b) const;

    /// Whether an edge of a triangle lies on an edge of the file.
    [[nodiscard]] bool isBorder(std::size_t face, std::uint32_t a, std::uint32_t b) const;

private:
    struct Face {
        EdgeKind within = EdgeKind::Inner;
        std::unordered_map<std::uint64_t, EdgeKind> kinds;  // by the nodes, the smaller one in the upper half
    };
    std::vector<Face> faces_;
};

}  // namespace inkedge::cad

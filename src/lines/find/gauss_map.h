#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "lines/find/mesh_edges.h"

namespace inkedge::lines {

/// The edges of a mesh as arcs on the unit sphere between the normals of their two faces. In an orthographic view an
/// edge is a contour if its arc crosses the great circle at right angles to the view direction (Hertzmann 1999, section
/// 3.2).
///
/// The sphere is projected from its centre to a cube, whose sides are quadtrees. An arc is kept in the smallest cell
/// that holds it. Cells are widened by half their size on all sides for this, so that no small arc is kept in a large
/// cell only because it lies across a border between cells.
class GaussMap {
public:
    /// O(n log n). Edges between faces with the same normal and MeshEdges::edgeOnSines are left out: they are never
    /// contours.
    explicit GaussMap(const MeshEdges&);

    /// Finds the edges that may be contours: all contours, and some edges whose arcs only come near the great circle.
    /// @param direction  of the view, in mesh space; of any length
    /// @param to         receives the edges in no order
    void findNear(glm::dvec3 direction, std::vector<std::uint32_t>& to) const;

    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    struct Cell {
        float u, v;           // the centre on the side of the cube, which runs from -1 to 1
        float half;           // half the side of the widened cell
        std::uint32_t begin;  // into edges_: those of the cell itself
        std::uint32_t end;
        std::uint32_t after;  // into cells_: the first cell after this one's descendants
        std::uint32_t side;
    };
    // A cell's coordinates in the quadtree of a side.
    struct Square {
        std::uint32_t side, level, x, y;
    };

    void addCell(const std::vector<std::uint64_t>& arcs, std::size_t begin, std::size_t end, Square);

    std::vector<Cell> cells_;           // each before its descendants
    std::vector<std::uint32_t> edges_;  // into MeshEdges::shared
    std::size_t largeEnd_ = 0;          // the first edges of edges_, up to here, fit no cell
    double largestSine_ = 0.0;          // of MeshEdges::edgeOnSines
};

}  // namespace inkedge::lines

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "lines/find/mesh_edges.h"

namespace inkedge::lines {

/// The edges of a mesh as arcs between their two faces' normals on the unit sphere. In an orthographic view an edge is
/// a contour if its arc crosses the great circle at right angles to the view direction (Hertzmann 1999, section 3.2).
///
/// The sphere is a cube whose sides are quadtrees, seen from its centre. An arc lies in the smallest cell, widened by
/// half its size on all sides, that holds it: so no arc is kept large only because it lies across a border between
/// cells.
class GaussMap {
public:
    /// O(n log n). Edges between faces of one normal are left out: they are no contours.
    explicit GaussMap(const MeshEdges&);

    /// The edges that may be contours: all those that are, and some whose arcs only come near the great circle.
    /// @param direction  of the view, in the mesh's space; of any length
    /// @param to         receives them in no order
    void findNear(glm::dvec3 direction, std::vector<std::uint32_t>& to) const;

    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    struct Cell {
        float u, v;           // its centre on the side of the cube, which runs from -1 to 1
        float half;           // of its widened side
        std::uint32_t begin;  // into edges_, of its own
        std::uint32_t end;
        std::uint32_t after;  // into cells_: the first that is not below it
        std::uint32_t side;
    };
    struct Place {
        std::uint32_t side, level, x, y;
    };

    void addCell(const std::vector<std::uint64_t>& arcs, std::size_t begin, std::size_t end, Place);

    std::vector<Cell> cells_;           // each before those below it
    std::vector<std::uint32_t> edges_;  // into MeshEdges::shared
    std::size_t largeEnd_ = 0;          // of those at the beginning of edges_ that no cell holds
};

}  // namespace inkedge::lines

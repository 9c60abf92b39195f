#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

#include "lines/find/box_levels.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// The faces of a mesh in a tree of boxes. Faces that repeat another are left out. Mesh space less origin.
struct FaceTree {
    /// Four faces side by side. One that is none lies at infinity.
    struct Packet {
        Four corners[3][3];  ///< of each face, by axis
        [[nodiscard]] FourBoxes boxes() const noexcept {
            FourBoxes boxes;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                boxes.low[axis] = smaller(smaller(corners[0][axis], corners[1][axis]), corners[2][axis]);
                boxes.high[axis] = larger(larger(corners[0][axis], corners[1][axis]), corners[2][axis]);
            }
            return boxes;
        }
    };

    std::vector<glm::vec3> points;         ///< one per point of the topology
    std::vector<std::uint32_t> triangles;  ///< of the mesh, along a Z-order curve: packet p has 4 p to 4 p + 3
    std::vector<Packet> packets;
    BoxLevels boxes;  ///< of the packets
};

/// O(n)
[[nodiscard]] FaceTree buildFaceTree(const Mesh&, const mesh::MeshTopology&);

}  // namespace inkedge::lines

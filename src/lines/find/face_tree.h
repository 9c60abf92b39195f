#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>

#include "lines/find/box_levels.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// The faces of a mesh in a tree of boxes. Faces that repeat another are left out. Mesh space less origin. Where a mesh
/// knows the faces of a CAD file, a packet holds triangles of one of them.
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

    std::vector<glm::vec3> points;  ///< one per point of the topology
    /// Of the mesh, along a Z-order curve: packet p has 4 p to 4 p + 3. The last of a packet may be none.
    std::vector<std::uint32_t> triangles;
    static constexpr std::uint32_t none = ~0U;
    std::vector<Packet> packets;
    BoxLevels boxes;  ///< of the packets

    /// How many faces a packet has.
    [[nodiscard]] unsigned facesIn(std::uint32_t packet) const noexcept {
        const std::size_t first = 4 * std::size_t{packet};
        unsigned count = 1;
        while (count < 4 && first + count < triangles.size() && triangles[first + count] != none) ++count;
        return count;
    }
};

/// O(n)
[[nodiscard]] FaceTree buildFaceTree(const Mesh&, const mesh::MeshTopology&);

}  // namespace inkedge::lines

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge::lines {

/// The faces of a mesh in a tree of boxes. Each box has a cone around the normals of its faces, so that a search for
/// crossing faces can skip nodes that are nearly flat. Repeated faces and those without a normal are left out.
///
/// The tree is split along a Z-order curve through the faces' middles. Its nodes are in depth-first order, so that the
/// first child of node i is i + 1.
struct FaceTree {
    struct Node {
        glm::vec3 low;
        glm::vec3 high;
        glm::vec3 axis;        ///< of a cone that holds every normal or its opposite; unit
        float angle;           ///< of the cone, radians; wideCone: the cone is too wide to be useful
        std::uint32_t second;  ///< the second child; 0: a leaf
        std::uint32_t begin;   ///< into triangles
        std::uint32_t end;
    };
    static constexpr float wideCone = 4.0F;
    static constexpr std::uint32_t leafSize = 4;

    std::vector<glm::dvec3> normals;       ///< one per triangle of the mesh, as MeshTopology::faceNormals
    std::vector<glm::vec3> points;         ///< one per point of the topology: mesh space less origin
    std::vector<std::uint32_t> triangles;  ///< of the mesh
    std::vector<Node> nodes;               ///< the root first; none: no faces
};

/// @param maxAngle  radians: wider cones are not kept
/// O(n log n)
[[nodiscard]] FaceTree buildFaceTree(const Mesh&, const mesh::MeshTopology&, double maxAngle);

}  // namespace inkedge::lines

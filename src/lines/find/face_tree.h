#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge {

/// The faces of a mesh in a tree of boxes, each with a cone around its faces' normals, so that a search for crossing
/// faces need not look into what is nearly flat. Repeated faces and those without a normal are left out.
///
/// The tree splits where the faces' middles part along a Z-order curve; its nodes stand in depth-first order, so the
/// first child of node i is i + 1.
struct FaceTree {
    struct Node {
        glm::vec3 low;
        glm::vec3 high;
        glm::vec3 axis;        ///< unit; of the cone that holds every normal or its opposite
        float angle;           ///< of the cone, radians; wideCone where it is of no use
        std::uint32_t second;  ///< the second child; 0: a leaf
        std::uint32_t begin;   ///< into triangles
        std::uint32_t end;
    };
    static constexpr float wideCone = 4.0F;
    static constexpr std::uint32_t leafSize = 4;

    std::vector<glm::dvec3> normals;       ///< one a triangle of the mesh, as MeshTopology::faceNormals
    std::vector<glm::vec3> points;         ///< one a point of the topology: where it stands, mesh space less origin
    std::vector<std::uint32_t> triangles;  ///< of the mesh
    std::vector<Node> nodes;               ///< the root first; none: no faces
};

/// @param widest  radians: cones over this are not kept
/// O(n log n)
[[nodiscard]] FaceTree buildFaceTree(const Mesh&, const MeshTopology&, double widest);

}  // namespace inkedge

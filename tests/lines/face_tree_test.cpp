#include "lines/find/face_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "lines/find/face_cones.h"
#include "lines/find/file_faces.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::lines {
namespace {

using namespace scenes;

struct Made {
    Scene scene;
    const Mesh& mesh = scene.meshes()[0];
    const mesh::MeshTopology& topology = scene::topologyOf(scene, 0);
    FaceTree tree = buildFaceTree(mesh, topology);
};

// Calls visit(level, index, packet) for a packet and each node above it, as a child of its parent.
template <class Visit>
void forEachAbove(const FaceTree& tree, std::uint32_t packet, Visit&& visit) {
    std::uint32_t index = packet;
    for (std::uint32_t level = 0; level < tree.boxes.top(); ++level, index /= 4) visit(level, index);
}

TEST(FaceTree, HoldsEachFaceOnceInBoxesThatHoldIt) {
    for (const std::uint32_t segments : {6U, 8U, 100U}) {
        const Made made{sceneOf(sphere(1.0, segments))};
        std::vector<std::uint32_t> triangles = made.tree.triangles;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            forEachAbove(made.tree, i / 4, [&](std::uint32_t level, std::uint32_t index) {
                const FourBoxes& boxes = made.tree.boxes.boxes(level, index / 4);
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const glm::vec3 corner = made.tree.points[made.topology.points[3 * triangles[i] + k]];
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_EQ(made.tree.packets[i / 4].corners[k][axis][i % 4], corner[axis]);
                        ASSERT_GE(corner[axis], boxes.min(index % 4)[axis]);
                        ASSERT_LE(corner[axis], boxes.max(index % 4)[axis]);
                    }
                }
            });
        }
        std::ranges::sort(triangles);
        EXPECT_EQ(std::ranges::adjacent_find(triangles), triangles.end());
        const auto originals = made.topology.originals;
        std::size_t count = 0;
        for (std::uint32_t t = 0; t < originals.size(); ++t) count += originals[t] == t ? 1 : 0;
        EXPECT_EQ(triangles.size(), count);
    }
}

TEST(FaceTree, HasPacketsOfOneFaceOfACadFile) {
    Mesh ball = sphere(1.0, 40);
    ball.parameters.resize(ball.positions.size());
    for (std::uint32_t t = 0; t < ball.indices.size() / 3; ++t) ball.faces.push_back(7 * t % 11);
    const Made made{sceneOf(ball)};
    const FileFaces faces{made.tree, made.mesh, made.topology};
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t p = 0; p < made.tree.packets.size(); ++p) {
        EXPECT_TRUE(faces.areBeside(0, p, 0, p));
        for (std::uint32_t k = 0; k < made.tree.facesIn(p); ++k) {
            triangles.push_back(made.tree.triangles[4 * p + k]);
            EXPECT_EQ(made.mesh.faces[triangles.back()], made.mesh.faces[made.tree.triangles[4 * p]]);
        }
    }
    std::ranges::sort(triangles);
    EXPECT_EQ(triangles.size(), made.mesh.indices.size() / 3);
    EXPECT_EQ(std::ranges::adjacent_find(triangles), triangles.end());
}

TEST(FaceTree, IsEmptyForAMeshWithoutFaces) {
    const Mesh none;
    const FaceTree tree = buildFaceTree(none, mesh::buildTopology(none));
    EXPECT_TRUE(tree.boxes.empty());
}

TEST(FaceCones, HoldEveryNormalOrItsOpposite) {
    const Made made{sceneOf(sphere(1.0, 100))};
    const std::vector<glm::dvec3> normals = mesh::makeFaceNormals(made.mesh, made.topology);
    constexpr float widest = 0.5F;
    const FaceCones cones{made.tree, normals, widest};
    int kept = 0;
    for (std::uint32_t i = 0; i < made.tree.triangles.size(); ++i) {
        const glm::vec3 normal{normals[made.tree.triangles[i]]};
        if (normal == glm::vec3{0.0F}) continue;
        forEachAbove(made.tree, i / 4, [&](std::uint32_t level, std::uint32_t index) {
            const FourCones& four = cones.cones(level, index / 4);
            const auto k = index % 4;
            if (four.radius[k] == FourCones::wide) return;
            ++kept;
            const glm::vec3 axis{four.axis[0][k], four.axis[1][k], four.axis[2][k]};
            const float off = std::min(glm::distance(normal, axis), glm::distance(-normal, axis));
            ASSERT_LE(off, four.radius[k] + 1e-6F);  // of floats near 1
            ASSERT_LE(four.radius[k], widest);
        });
    }
    EXPECT_GT(kept, 10'000);
}

}  // namespace
}  // namespace inkedge::lines

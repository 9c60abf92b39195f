#include "mesh/arrange.h"

#include <gmock/gmock.h>

#include "scenes.h"

namespace inkedge::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A sheet of two triangles whose vertices come after one that nothing uses.
Mesh sheet() {
    Mesh mesh = scenes::quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});
    for (std::uint32_t& i : mesh.indices) ++i;
    return mesh;
}

TEST(DropUnusedVertices, KeepsWhatBelongsToTheOthers) {
    Mesh mesh = sheet();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals.emplace_back(0, 0, i);
        mesh.textureCoordinates.emplace_back(i, 0);
    }
    dropUnusedVertices(mesh);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{1, 1, 0}, glm::vec3{0, 1, 0}));
    EXPECT_THAT(mesh.normals,
                ElementsAre(glm::vec3{0, 0, 1}, glm::vec3{0, 0, 2}, glm::vec3{0, 0, 3}, glm::vec3{0, 0, 4}));
    EXPECT_EQ(mesh.textureCoordinates.back(), (glm::vec2{4, 0}));
    EXPECT_THAT(mesh.paint, IsEmpty());
}

TEST(BringForward, TakesAlongWhatIsSaidOfTrianglesAndTheirEdges) {
    Mesh mesh = sheet();
    mesh.faces = {7, 8};
    mesh.edges.resize(6);
    mesh.edges[4] = EdgeKind::Sharp;
    bringForward(mesh, {false, true});
    EXPECT_THAT(mesh.indices, ElementsAre(1, 3, 4, 1, 2, 3));
    EXPECT_THAT(mesh.faces, ElementsAre(8, 7));
    EXPECT_THAT(scenes::edgesOfKind(mesh, EdgeKind::Sharp), ElementsAre(false, true, false, false, false, false));
    EXPECT_THAT(mesh.materials, IsEmpty());
}

}  // namespace
}  // namespace inkedge::mesh

#include "mesh/arrange.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

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

TEST(ArrangeVertices, KeepsWhatBelongsToTheOthers) {
    Mesh mesh = sheet();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals.emplace_back(0, 0, i);
        mesh.textureCoordinates.emplace_back(i, 0);
    }
    arrangeVertices(mesh);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{1, 1, 0}, glm::vec3{0, 1, 0}));
    EXPECT_THAT(mesh.normals,
                ElementsAre(glm::vec3{0, 0, 1}, glm::vec3{0, 0, 2}, glm::vec3{0, 0, 3}, glm::vec3{0, 0, 4}));
    EXPECT_EQ(mesh.textureCoordinates.back(), (glm::vec2{4, 0}));
    EXPECT_THAT(mesh.paint, IsEmpty());
}

TEST(ArrangeVertices, FollowsTheTriangles) {
    Mesh mesh = scenes::quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    mesh.indices = {3, 0, 2, 2, 0, 1};
    arrangeVertices(mesh);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 2, 1, 3));
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3{0, 1, 0}, glm::vec3{0, 0, 0}, glm::vec3{1, 1, 0}, glm::vec3{1, 0, 0}));
}

// The triangles of a sphere of more than a hundred thousand, as a tool may write them that hashes them.
Mesh shuffled() {
    Mesh mesh = scenes::sphere(1.0, 512);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    std::ranges::shuffle(triangles, std::minstd_rand{1});
    mesh.indices.clear();
    for (const auto& t : triangles) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
    mesh.materials.resize(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) mesh.materials[t] = triangles[t][0];
    return mesh;
}

double meanStep(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 3; i < mesh.indices.size(); i += 3)
        sum += glm::distance(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i - 3]]);
    return 3.0 * sum / static_cast<double>(mesh.indices.size());
}

TEST(ArrangeTriangles, BringsTogetherWhatIsScattered) {
    Mesh mesh = shuffled();
    const Mesh before = mesh;
    arrangeTriangles(mesh);
    EXPECT_GT(meanStep(before), 1.0);
    EXPECT_LT(meanStep(mesh), 0.05);
    const auto sorted = [](const Mesh& of) {
        std::vector<std::array<std::uint32_t, 4>> all;
        for (std::size_t t = 0; t < of.materials.size(); ++t)
            all.push_back({of.indices[3 * t], of.indices[3 * t + 1], of.indices[3 * t + 2], of.materials[t]});
        std::ranges::sort(all);
        return all;
    };
    EXPECT_EQ(sorted(mesh), sorted(before)) << "the same triangles, with their materials";
}

TEST(ArrangeTriangles, LeavesAloneWhatLiesTogetherOrSaysMore) {
    Mesh together = scenes::sphere(1.0, 512);
    const std::vector<std::uint32_t> indices = together.indices;
    arrangeTriangles(together);
    EXPECT_EQ(together.indices, indices);
    Mesh withFaces = shuffled();
    withFaces.faces.resize(withFaces.indices.size() / 3);
    const std::vector<std::uint32_t> inTheirOrder = withFaces.indices;
    arrangeTriangles(withFaces);
    EXPECT_EQ(withFaces.indices, inTheirOrder);
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

#include "mesh/authored_normals.h"

#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "mesh/shapes.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using testing::Each;
using testing::IsEmpty;

struct Judged {
    Mesh mesh;
    std::vector<bool> disbelieved;
};

Judged judged(Mesh mesh, Normals normals = Normals::Auto) {
    LoadSettings settings;
    settings.normals = normals;
    keepUsableNormals(mesh, settings);
    MeshTopology topology = buildTopology(mesh);
    const std::vector<glm::dvec3> before = topology.faceNormals;
    std::vector<bool> disbelieved = judgeNormals(mesh, topology, settings);
    const MeshTopology after = buildTopology(mesh);
    EXPECT_EQ(topology.points, after.points) << "what was turned over is turned over in the topology, too";
    EXPECT_EQ(topology.twins, after.twins);
    EXPECT_EQ(topology.faceNormals, after.faceNormals);
    return {std::move(mesh), std::move(disbelieved)};
}

void turnFaces(Mesh& mesh, std::size_t every) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3 * every) turnOver(mesh, t);
}

void expectBelieved(const Mesh& mesh) {
    const Judged found = judged(mesh);
    EXPECT_THAT(found.disbelieved, IsEmpty());
    EXPECT_EQ(found.mesh.normals, mesh.normals);
    EXPECT_EQ(found.mesh.indices, mesh.indices);
}

void expectDisbelieved(const Mesh& mesh) {
    const Judged found = judged(mesh);
    EXPECT_THAT(found.disbelieved, Each(true));
    EXPECT_THAT(found.mesh.normals, Each(glm::vec3{0.0F}));
    EXPECT_EQ(found.mesh.indices, mesh.indices) << "faces stay as they are wound";
}

Mesh withFacetNormals(Mesh mesh) {
    mesh.normals = facetNormals(mesh);
    return mesh;
}

// All corners of a cube share the mean of their faces' normals.
Mesh averagedCube() {
    Mesh mesh = scenes::cube();
    for (const glm::vec3 p : mesh.positions) mesh.normals.push_back(glm::normalize(p));
    return mesh;
}

TEST(JudgeNormals, believesThoseOfSmoothOfFlatAndOfAveragedFaces) {
    expectBelieved(scenes::sphere());
    expectBelieved(scenes::sphere(1.0, 12));
    expectBelieved(withFacetNormals(prism(24)));
    expectBelieved(averagedCube());
}

TEST(JudgeNormals, believesSmoothOnesWhoseVerticesAreSplit) {
    Mesh mesh = withFacetNormals(prism(8));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (std::abs(mesh.normals[i].y) < 0.5F)
            mesh.normals[i] = glm::normalize(mesh.positions[i] * glm::vec3{1.0F, 0.0F, 1.0F});
    expectBelieved(mesh);
}

TEST(JudgeNormals, disbelievesThoseOfOtherAxes) {
    Mesh turned = torus();
    for (glm::vec3& n : turned.normals) n = {n.x, -n.z, n.y};
    expectDisbelieved(turned);
    Mesh mirrored = torus();
    for (glm::vec3& n : mirrored.normals) n.x = -n.x;
    expectDisbelieved(mirrored);
    Mesh box = withFacetNormals(prism(4));
    for (glm::vec3& n : box.normals) n.y = -n.y;
    expectDisbelieved(box);
}

TEST(JudgeNormals, disbelievesRandomOnes) {
    std::mt19937 random{1};  // NOLINT: the same each time
    std::uniform_real_distribution<float> within{-1.0F, 1.0F};
    Mesh mesh = prism(24);
    mesh.normals = facetNormals(mesh);
    for (glm::vec3& n : mesh.normals) n = glm::normalize(n + glm::vec3{within(random), within(random), within(random)});
    expectDisbelieved(mesh);
}

TEST(JudgeNormals, disbelievesThoseTurnedOverAgainstAWindingThatIsOutward) {
    Mesh mesh = torus();
    for (glm::vec3& n : mesh.normals) n = -n;
    expectDisbelieved(mesh);
    Mesh open = withFacetNormals(strips({20.0, 30.0}));
    for (glm::vec3& n : open.normals) n = -n;
    expectDisbelieved(open);
}

TEST(JudgeNormals, turnsAClosedComponentOverWhoseWindingIsInward) {
    const Mesh right = torus();
    Mesh inward = right;
    turnFaces(inward, 1);
    const Judged found = judged(inward);
    EXPECT_THAT(found.disbelieved, IsEmpty());
    EXPECT_EQ(found.mesh.indices, right.indices);
    EXPECT_EQ(found.mesh.normals, right.normals);
}

TEST(JudgeNormals, windsFacesByThemWhereTheWindingIsNotConsistent) {
    for (const Mesh& right : {torus(), withFacetNormals(prism(4)), withFacetNormals(strips({20.0, 30.0}))}) {
        for (const std::size_t every : {2U, 3U, 5U}) {
            Mesh mesh = right;
            turnFaces(mesh, every);
            const Judged found = judged(mesh);
            EXPECT_THAT(found.disbelieved, IsEmpty());
            EXPECT_EQ(found.mesh.indices, right.indices);
        }
    }
}

TEST(JudgeNormals, decidesForEachComponent) {
    Mesh mesh = torus();
    const std::size_t faces = mesh.indices.size() / 3;
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh other = torus();
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.push_back(other.positions[i] + glm::vec3{10.0F, 0.0F, 0.0F});
        const glm::vec3 n = other.normals[i];
        mesh.normals.emplace_back(n.x, -n.z, n.y);
    }
    for (const std::uint32_t i : other.indices) mesh.indices.push_back(count + i);
    const Judged found = judged(mesh);
    ASSERT_EQ(found.disbelieved.size(), 2 * faces);
    for (std::size_t t = 0; t < 2 * faces; ++t) EXPECT_EQ(found.disbelieved[t], t >= faces);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        EXPECT_EQ(found.mesh.normals[i], i < count ? mesh.normals[i] : glm::vec3{0.0F});
}

TEST(JudgeNormals, keepsThoseThatTheSettingsAskFor) {
    Mesh mesh = torus();
    for (glm::vec3& n : mesh.normals) n = {n.x, -n.z, n.y};
    const Judged found = judged(mesh, Normals::Authored);
    EXPECT_THAT(found.disbelieved, Each(true));
    EXPECT_EQ(found.mesh.normals, mesh.normals);
}

TEST(KeepUsableNormals, dropsWhatIsNotFiniteOrNotWanted) {
    Mesh mesh = strips({});
    mesh.normals.assign(4, glm::vec3{0, 1, 0});
    mesh.normals[1].x = std::numeric_limits<float>::quiet_NaN();
    Mesh kept = mesh;
    keepUsableNormals(kept, {});
    EXPECT_THAT(kept.normals,
                testing::ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)));
    LoadSettings flat;
    flat.normals = Normals::Flat;
    keepUsableNormals(mesh, flat);
    EXPECT_THAT(mesh.normals, Each(glm::vec3{0.0F}));
}

}  // namespace
}  // namespace inkedge::mesh

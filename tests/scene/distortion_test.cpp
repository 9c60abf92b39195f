#include "scene/distortion.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scenes.h"

namespace inkedge::scene {
namespace {

using testing::SizeIs;

Scene::Data dataOf(const Mesh& mesh, const std::vector<glm::dmat4>& transforms) {
    Scene::Data data;
    data.meshes = {mesh};
    for (const glm::dmat4& transform : transforms) data.instances.push_back({"node", 0, transform});
    return data;
}

glm::dvec3 position(const Scene::Data& data, std::size_t instance, std::size_t vertex) {
    const Instance& i = data.instances[instance];
    const Mesh& mesh = data.meshes[i.mesh];
    return glm::dvec3{i.transform * glm::dvec4{mesh.origin + glm::dvec3{mesh.positions[vertex]}, 1.0}};
}

glm::dmat4 shear() {
    glm::dmat4 m{1.0};
    m[1] = {0.5, 1.0, 0.2, 0.0};
    return scenes::translation({10, 20, 30}) * m;
}

TEST(BakeDistortedInstances, leavesWhatKeepsAnglesAlone) {
    for (const glm::dmat4& kept :
         {glm::dmat4{1.0}, scenes::rotation(33, {1, 2, 3}), scenes::scaling(glm::dvec3{0.01}),
          scenes::scaling({-1, 1, 1}), scenes::translation({1e6, 0, 0}) * scenes::rotation(5, {0, 1, 0})}) {
        Scene::Data data = dataOf(scenes::cube(), {kept, kept});
        bakeDistortedInstances(data, LoadLimits{}.vertices);
        EXPECT_THAT(data.meshes, SizeIs(1));
        EXPECT_EQ(data.instances[1].transform, kept);
    }
}

TEST(BakeDistortedInstances, movesEveryVertexToWhereItStoodBefore) {
    Mesh mesh = scenes::box({1, 2, 3});
    mesh.origin = {100, -50, 7};
    for (const glm::dmat4& m : {shear(), scenes::scaling({1, 2, 1}), shear() * scenes::scaling({-3, 1, 1})}) {
        const Scene::Data before = dataOf(mesh, {m});
        Scene::Data after = before;
        bakeDistortedInstances(after, LoadLimits{}.vertices);
        ASSERT_THAT(after.meshes, SizeIs(1)) << "the mesh that no instance uses any more is kept";
        const glm::dmat3 linear{after.instances[0].transform};
        EXPECT_EQ(linear, glm::dmat3{1.0});
        // Positions less their origin are floats: 1e-7 of ten units.
        for (std::size_t v = 0; v < 8; ++v)
            EXPECT_LT(glm::distance(position(before, 0, v), position(after, 0, v)), 2e-6) << v;
    }
}

TEST(BakeDistortedInstances, keepsTheMeshForInstancesThatDoNotDistort) {
    Scene::Data data = dataOf(scenes::cube(), {glm::dmat4{1.0}, shear(), scenes::scaling({2, 1, 1})});
    bakeDistortedInstances(data, LoadLimits{}.vertices);
    EXPECT_THAT(data.meshes, SizeIs(3));
    EXPECT_EQ(data.meshes[data.instances[0].mesh].positions, scenes::cube().positions);
    EXPECT_NE(data.instances[1].mesh, data.instances[2].mesh);
}

TEST(BakeDistortedInstances, keepsNormalsAcrossTheirSurfaces) {
    Scene::Data data = dataOf(scenes::sphere(1.0, 48), {shear() * scenes::scaling({1, 3, -1})});
    bakeDistortedInstances(data, LoadLimits{}.vertices);
    const Mesh& mesh = data.meshes[data.instances[0].mesh];
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    int checked = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const auto p = [&](std::size_t k) { return glm::dvec3{mesh.positions[mesh.indices[t + k]]}; };
        const glm::dvec3 face = glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 normal{mesh.normals[mesh.indices[t + k]]};
            ASSERT_NEAR(glm::length(normal), 1.0, 1e-6);
            // Outwards, by winding too, and across the face but for the sphere's curve over it, which the stretch
            // doubles.
            ASSERT_GT(glm::dot(face, normal), 0.85) << "triangle " << t / 3;
            ++checked;
        }
    }
    EXPECT_GT(checked, 5000);
}

TEST(BakeDistortedInstances, bearsAScaleOfZero) {
    Scene::Data data = dataOf(scenes::sphere(1.0, 16), {scenes::scaling({1, 0, 1})});
    bakeDistortedInstances(data, LoadLimits{}.vertices);
    for (const glm::vec3 n : data.meshes[0].normals) {
        const float length = glm::length(n);
        EXPECT_TRUE(length == 0.0F || std::abs(length - 1.0F) < 1e-5F);
    }
}

}  // namespace
}  // namespace inkedge::scene

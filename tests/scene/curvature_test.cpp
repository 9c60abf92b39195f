#include "scene/curvature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.h"

namespace inkedge {
namespace {

Scene curved(const Mesh& mesh) {
    LoadSettings settings;
    settings.curvature = true;
    return scenes::sceneOf({{mesh, glm::dmat4{1.0}}}, settings);
}

TEST(MeanCurvature, ofASphereIsOneOverItsRadius) {
    for (const double radius : {0.5, 2.0}) {
        const Scene scene = curved(scenes::sphere(radius, 96));
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_EQ(mesh.curvatures.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            // A sphere of 96 segments deviates by the square of half a step's angle, (pi / 96)^2; near the poles, where
            // triangles are slivers, area is shared less evenly.
            if (std::abs(static_cast<double>(mesh.positions[i].y)) > 0.9 * radius) continue;
            EXPECT_NEAR(static_cast<double>(mesh.curvatures[i]) * radius, 1.0, 0.02) << i;
        }
    }
}

TEST(MeanCurvature, ofASphereSeenFromInsideIsNegative) {
    Mesh mesh = scenes::sphere(1.0, 48);
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t], mesh.indices[t + 1]);
    for (glm::vec3& normal : mesh.normals) normal = -normal;
    EXPECT_LT(curved(mesh).meshes()[0].curvatures[48 * 12], -0.9F);
}

TEST(MeanCurvature, ofAPlaneIsNothingAndAcrossACreaseOfAreaA) {
    const Scene flat = curved(scenes::quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}));
    for (const float c : flat.meshes()[0].curvatures) EXPECT_EQ(c, 0.0F);
    // A roof over the edge from (0, 0, 0) to (0, 1, 0), of two triangles at right angles: length 1, angle pi / 2, a
    // quarter of it for each end, whose area is a third of both triangles' 1/2.
    Mesh roof;
    roof.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};
    roof.indices = {0, 1, 2, 1, 0, 3};
    const Scene bent = curved(roof);
    double most = 0.0;
    for (const float c : bent.meshes()[0].curvatures) most = std::max(most, std::abs(static_cast<double>(c)));
    EXPECT_NEAR(most, 0.25 * std::numbers::pi / 2.0 / (1.0 / 3.0), 1e-6);
}

TEST(MeanCurvature, isNotMadeUnlessAskedFor) {
    EXPECT_TRUE(scenes::sceneOf(scenes::sphere(1.0, 16)).meshes()[0].curvatures.empty());
}

}  // namespace
}  // namespace inkedge

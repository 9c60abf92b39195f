#include "mesh/curvature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.h"

namespace inkedge::mesh {
namespace {

double maximumOf(const Scene& scene) {
    double maximum = 0.0;
    for (const float c : scene.meshes()[0].curvatures) maximum = std::max(maximum, std::abs(static_cast<double>(c)));
    return maximum;
}

Scene curved(const Mesh& mesh, double creaseAngle = LoadSettings{}.creaseAngle) {
    LoadSettings settings;
    settings.creaseAngle = creaseAngle;
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

TEST(MeanCurvature, ofAPlaneIsNothingAndAcrossABendOfAreaA) {
    const Scene flat = curved(scenes::quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}));
    for (const float c : flat.meshes()[0].curvatures) EXPECT_EQ(c, 0.0F);
    // A roof over the edge from (0, 0, 0) to (0, 1, 0), of two triangles at right angles: length 1, angle pi / 2, a
    // quarter of it for each end, whose area is a third of both triangles' 1/2.
    Mesh roof;
    roof.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};
    roof.indices = {0, 1, 2, 1, 0, 3};
    EXPECT_NEAR(maximumOf(curved(roof, 91.0)), 0.25 * std::numbers::pi / 2.0 / (1.0 / 3.0), 1e-6);
    EXPECT_EQ(maximumOf(curved(roof, 89.0)), 0.0) << "a crease";
}

TEST(MeanCurvature, endsAtCreases) {
    // A tube between two flat lids: half of one over its radius, up to its rims.
    constexpr int sides = 90;
    Mesh tube;
    const auto position = [](int i, float z) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        return glm::vec3{std::cos(angle), std::sin(angle), z};
    };
    for (const float z : {0.0F, 0.1F})
        for (int i = 0; i < sides; ++i) tube.positions.push_back(position(i, z));
    tube.positions.insert(tube.positions.end(), {{0, 0, 0}, {0, 0, 0.1F}});
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        for (const std::uint32_t c : {i, next, sides + next, i, sides + next, sides + i}) tube.indices.push_back(c);
        for (const std::uint32_t c : {next, i, 2U * sides, sides + i, sides + next, 2U * sides + 1})
            tube.indices.push_back(c);
    }
    const Scene scene = curved(tube);
    const Mesh& mesh = scene.meshes()[0];
    ASSERT_FALSE(mesh.normals.empty());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const bool onLid = std::abs(mesh.normals[i].z) > 0.5F;
        EXPECT_NEAR(static_cast<double>(mesh.curvatures[i]), onLid ? 0.0 : 0.5, 0.01) << i;
    }
}

// Bumps of one edge's length on a sphere stand for the noise of a scan.
TEST(MeanCurvature, ofARoughSurfaceIsNearlyThatOfASmoothOne) {
    Mesh rough = scenes::sphere(1.0, 256);
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < rough.positions.size(); ++i) {
        random = random * 1664525U + 1013904223U;
        const float bump = 0.002F * (static_cast<float>(random >> 8U) / 8388608.0F - 1.0F);
        // The first and the last of a ring are one point, and so are all of a pole.
        if (i % 257 == 256)
            rough.positions[i] = rough.positions[i - 256];
        else if (i > 257 && i < rough.positions.size() - 257)
            rough.positions[i] *= 1.0F + bump;
    }
    const Scene scene = curved(rough, 90.0);
    double squares = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < rough.positions.size(); ++i) {
        if (std::abs(rough.positions[i].y) > 0.7F) continue;
        const double off = static_cast<double>(scene.meshes()[0].curvatures[i]) - 1.0;
        squares += off * off;
        ++count;
    }
    // At single points it is some 2 off: bumps of 0.002 over edges of 0.025.
    EXPECT_LT(std::sqrt(squares / count), 0.5);
}

TEST(MeanCurvature, isNotMadeUnlessAskedFor) {
    EXPECT_TRUE(scenes::sceneOf(scenes::sphere(1.0, 16)).meshes()[0].curvatures.empty());
}

}  // namespace
}  // namespace inkedge::mesh

#include "scene/coplanar_layers.h"

#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::scene {
namespace {

using testing::Each;
using testing::ElementsAre;

// One flag per patch of an instance, in the order of instances.
const std::vector<bool>& layersOf(const Scene& scene) { return patchNumbersOf(scene).layered; }

Mesh square(double x, double y, double side, double z = 0.0) {
    return scenes::quad({x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z});
}

Scene nodes(const std::vector<Mesh>& meshes, const glm::dmat4& transform = glm::dmat4{1.0}) {
    std::vector<std::pair<Mesh, glm::dmat4>> instances;
    for (const Mesh& mesh : meshes) instances.emplace_back(mesh, transform);
    return scenes::sceneOf(instances);
}

TEST(CoplanarLayers, areOverlappingFacesOfDifferentNodes) {
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(0.5, 0.5, 1)})), ElementsAre(true, true)) << "one in the other";
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(1, 1, 2)})), ElementsAre(true, true))
        << "corners over each other";
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(0, 0, 2), square(5, 0, 1)})), ElementsAre(true, true, false));
}

TEST(CoplanarLayers, areOverlappingFacesOfDifferentPatchesInOneMesh) {
    Mesh two = square(0, 0, 2);
    for (const glm::vec3 p : square(0.5, 0.5, 1).positions) two.positions.push_back(p);
    two.indices.insert(two.indices.end(), {4, 5, 6, 4, 6, 7});
    EXPECT_THAT(layersOf(scenes::sceneOf(two)), ElementsAre(true, true));
}

TEST(CoplanarLayers, areNotNeighboursInOnePlane) {
    // They share an edge, a part of one, or a corner; none is over another.
    EXPECT_THAT(layersOf(nodes({square(0, 0, 1), square(1, 0.3, 1), square(-1, 1, 1), square(4, 4, 1)})), Each(false));
    // The same of closed bodies: a row of cubes, whose flush sides meet in edges. What lies against each other
    // overlaps.
    const Scene cubes =
        scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}, {scenes::cube(), scenes::translation({2, 0, 0})}});
    EXPECT_THAT(layersOf(cubes),
                ElementsAre(false, true, false, false, false, false, true, false, false, false, false, false));
}

// A square of many triangles.
Mesh grid(double x, double y, double side, std::uint32_t cells) {
    Mesh mesh;
    for (std::uint32_t i = 0; i <= cells; ++i)
        for (std::uint32_t j = 0; j <= cells; ++j)
            mesh.positions.emplace_back(glm::dvec3{x + side * i / cells, y + side * j / cells, 0.0});
    for (std::uint32_t i = 0; i < cells; ++i) {
        for (std::uint32_t j = 0; j < cells; ++j) {
            const std::uint32_t a = i * (cells + 1) + j;
            const std::uint32_t b = a + cells + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return mesh;
}

TEST(CoplanarLayers, areFoundAmongManyTriangles) {
    const Mesh large = grid(0, 0, 2, 200);
    ASSERT_GT(large.indices.size(), 3 * 50'000U) << "so many that most are put aside by the space they take";
    EXPECT_THAT(layersOf(nodes({large, square(1.999, 1.999, 1)})), ElementsAre(true, true)) << "at a corner";
    EXPECT_THAT(layersOf(nodes({large, square(1.001, 0.503, 0.001)})), ElementsAre(true, true)) << "within one cell";
    EXPECT_THAT(layersOf(nodes({large, square(2, 0, 1), square(0, 0, 1, 0.01)})), Each(false));
    EXPECT_THAT(layersOf(nodes({large, grid(0.5, 0.5, 2, 200)})), ElementsAre(true, true));
}

TEST(CoplanarLayers, areNotWhatLiesOverEachOtherApart) {
    // Two millionths of the scene's radius, 1.4, count as one plane; a thousandth of it shows as a step.
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(0.5, 0.5, 1, 1e-6)})), ElementsAre(true, true));
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(0.5, 0.5, 1, 1e-3)})), ElementsAre(false, false));
}

TEST(CoplanarLayers, areNotWhatCrossesInOneLine) {
    const Mesh upright = scenes::quad({0.2, 1, -1}, {1.8, 1, -1}, {1.8, 1, 1}, {0.2, 1, 1});
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), upright})), ElementsAre(false, false));
    const Mesh tilted = scenes::quad({0.2, 0.2, -0.01}, {1.8, 0.2, -0.01}, {1.8, 1.8, 0.01}, {0.2, 1.8, 0.01});
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), tilted})), ElementsAre(false, false));
}

TEST(CoplanarLayers, doNotAskWhichWayFacesLook) {
    Mesh back = square(0.5, 0.5, 1);
    for (std::size_t t = 0; t < back.indices.size(); t += 3) std::swap(back.indices[t + 1], back.indices[t + 2]);
    EXPECT_THAT(layersOf(nodes({square(0, 0, 2), back})), ElementsAre(true, true));
}

TEST(CoplanarLayers, areFoundInAnyPlaneAtAnySizeAndPosition) {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        for (int i = 0; i < 24; ++i) {
            const glm::dmat4 transform = scenes::translation(scale * glm::dvec3{300, -200, 100}) *
                                         scenes::rotation(15.0 * i + 0.1, {1, 0.3 * i, 2.0 - i}) *
                                         scenes::scaling(glm::dvec3{scale});
            EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(0.5, 0.5, 1)}, transform)), ElementsAre(true, true))
                << scale << ", " << i;
            EXPECT_THAT(layersOf(nodes({square(0, 0, 2), square(2, 0.5, 1)}, transform)), ElementsAre(false, false))
                << scale << ", " << i;
        }
    }
}

TEST(CoplanarLayers, areFoundBetweenAMeshAndItsMirrorImage) {
    const glm::dmat4 mirror = scenes::scaling({-1, 1, 1});
    const Mesh mesh = square(-0.5, 0, 2);
    EXPECT_THAT(layersOf(scenes::sceneOf({{mesh, glm::dmat4{1.0}}, {mesh, mirror}})), ElementsAre(true, true));
    const Mesh beside = square(0.5, 0, 2);
    EXPECT_THAT(layersOf(scenes::sceneOf({{beside, glm::dmat4{1.0}}, {beside, mirror}})), ElementsAre(false, false));
}

TEST(CoplanarLayers, areFoundAmongManyFaces) {
    // A floor of 60 x 60 quads and one tile on it; the floor's own faces are neighbours.
    Mesh floor;
    constexpr std::uint32_t side = 60;
    for (std::uint32_t i = 0; i <= side; ++i) {
        for (std::uint32_t k = 0; k <= side; ++k)
            floor.positions.emplace_back(0.1F * static_cast<float>(i), 0.1F * static_cast<float>(k), 0.0F);
    }
    for (std::uint32_t i = 0; i < side; ++i) {
        for (std::uint32_t k = 0; k < side; ++k) {
            const std::uint32_t v = i * (side + 1) + k;
            floor.indices.insert(floor.indices.end(), {v, v + side + 1, v + side + 2, v, v + side + 2, v + 1});
        }
    }
    EXPECT_THAT(layersOf(scenes::sceneOf(floor)), ElementsAre(false));
    EXPECT_THAT(layersOf(nodes({floor, square(3.03, 3.04, 0.02)})), ElementsAre(true, true));
    EXPECT_THAT(layersOf(nodes({floor, square(6.5, 3.04, 0.02)})), ElementsAre(false, false));
}

}  // namespace
}  // namespace inkedge::scene

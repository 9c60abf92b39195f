#include "scene/patch_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "scene/topology.h"
#include "scenes.h"

namespace inkedge {
namespace {

using scenes::cube;
using scenes::quad;
using scenes::sceneOf;
using testing::Contains;
using testing::Each;

const glm::dmat4 unmoved{1.0};

glm::dmat4 moved(double x, double y, double z) { return glm::translate(unmoved, glm::dvec3{x, y, z}); }

std::size_t differentNumbers(const Scene& scene) {
    const auto& numbers = scene.patchNumbers().number;
    return std::set<std::uint32_t>(numbers.begin(), numbers.end()).size();
}

// A strip of unit width along x = 0..1 in the plane y = 0, for z from 0 to 1.
Mesh floorTile() { return quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}); }

// The same tile hinged up about its border x = 0 and moved there: it goes on from x = 1 at this many degrees.
glm::dmat4 hingedAtOne(double degrees) { return glm::rotate(moved(1, 0, 0), glm::radians(degrees), glm::dvec3{0, 0, 1}); }

TEST(PatchNumbers, countFromOneOverAllInstances) {
    const Scene scene = sceneOf({{cube(), unmoved}, {cube(), moved(5, 0, 0)}});
    EXPECT_EQ(scene.patchNumbers().count, 12U);
    EXPECT_EQ(differentNumbers(scene), 12U);
    EXPECT_THAT(scene.patchNumbers().number, testing::Not(Contains(0U)));
    EXPECT_THAT(scene.patchNumbers().base, testing::ElementsAre(0U, 6U));
}

TEST(Seams, joinNodesWhoseSurfacesGoOnIntoEachOther) {
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), hingedAtOne(0)}})), 1U);
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), hingedAtOne(25)}})), 1U);
}

TEST(Seams, joinNothingThatBendsByMoreThanTheCreaseAngle) {
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), hingedAtOne(35)}})), 2U);
}

TEST(Seams, joinNothingThatFoldsBackOnItself) {
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), hingedAtOne(179)}})), 2U);
}

TEST(Seams, joinBordersThatShareOnlyPartOfTheirLength) {  // a T-junction
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), moved(1, 0, 0.5)}})), 1U);
}

TEST(Seams, joinNoBordersThatOnlyTouchAtTheirEnds) {
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), moved(1, 0, 1)}})), 2U);
}

TEST(Seams, joinNoBordersWithAGapBetween) {
    EXPECT_EQ(differentNumbers(sceneOf({{floorTile(), unmoved}, {floorTile(), moved(1.01, 0, 0)}})), 2U);
}

TEST(Seams, joinNothingAtEdgesThatManyFacesShare) {
    // Two coplanar halves of a floor and a wall between them, welded: the floor's line over the wall shows.
    Mesh mesh;
    for (const glm::vec3 p : {glm::vec3{-1, 0, 0}, {-1, 0, 1}, {0, 0, 1}, {0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0, -1, 1}}) {
        mesh.positions.push_back(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 3, 2, 7, 3, 7, 6};
    EXPECT_EQ(differentNumbers(sceneOf(mesh)), 3U);
}

TEST(CoplanarLayers, areFacesOfDifferentNodesThatOverlapInOnePlane) {
    const Scene scene = sceneOf({{floorTile(), unmoved}, {floorTile(), moved(0.5, 0, 0.25)}});
    EXPECT_THAT(scene.patchNumbers().layered, Each(true));
}

TEST(CoplanarLayers, areFoundWhicheverWayTheFacesFace) {
    const glm::dmat4 turnedOver = glm::rotate(moved(0.5, 0, 1), glm::radians(180.0), glm::dvec3{1, 0, 0});
    EXPECT_THAT(sceneOf({{floorTile(), unmoved}, {floorTile(), turnedOver}}).patchNumbers().layered, Each(true));
}

TEST(CoplanarLayers, areFoundInPlanesOfEveryDirection) {
    for (int i = 0; i < 24; ++i) {
        const glm::dmat4 tilt = glm::rotate(unmoved, 0.37 * i, glm::normalize(glm::dvec3{1.0, 0.3 * i, -0.7}));
        const Scene scene = sceneOf({{floorTile(), tilt}, {floorTile(), tilt * moved(0.5, 0, 0.25)}});
        EXPECT_THAT(scene.patchNumbers().layered, Each(true)) << "tilt " << i;
    }
}

TEST(CoplanarLayers, areNotNeighboursThatTouchInOnePlane) {
    // Two boxes side by side: their tops touch and do not overlap; the faces where they meet do, and are hidden.
    const Scene scene = sceneOf({{cube(), unmoved}, {cube(), moved(2, 0, 0)}});
    EXPECT_EQ(std::ranges::count(scene.patchNumbers().layered, true), 2);
}

TEST(CoplanarLayers, areNotFacesAStepApart) {
    const Scene scene = sceneOf({{floorTile(), unmoved}, {floorTile(), moved(0.5, 0.001, 0.25)}});
    EXPECT_THAT(scene.patchNumbers().layered, Each(false));
}

TEST(CoplanarLayers, areNotFacesOfOnePatch) {
    Mesh twice = floorTile();
    twice.indices.insert(twice.indices.end(), {0, 1, 2});  // repeats a triangle
    EXPECT_THAT(sceneOf(twice).patchNumbers().layered, Each(false));
}

TEST(Distortion, isBakedSoThatCreasesAreJudgedAsTheWorldShowsThem) {
    // A roof of 20 degrees on both sides bends by 40 at its ridge; pressed to a quarter of its height, by about 10.
    const double rise = std::tan(glm::radians(20.0));
    Mesh roof;
    for (const glm::dvec3 p : {glm::dvec3{-1, 0, 0}, {-1, 0, 1}, {0, rise, 1}, {0, rise, 0}, {1, 0, 1}, {1, 0, 0}}) {
        roof.positions.emplace_back(p);
    }
    roof.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    EXPECT_EQ(differentNumbers(sceneOf(roof)), 2U);
    EXPECT_EQ(differentNumbers(sceneOf(roof, glm::scale(unmoved, glm::dvec3{1, 0.25, 1}))), 1U);
    EXPECT_EQ(differentNumbers(sceneOf(roof, glm::scale(unmoved, glm::dvec3{0.25, 0.25, 0.25}))), 2U);
}

TEST(Distortion, keepsWhatStandsInTheWorld) {
    const glm::dmat4 sheared{{1, 0.5, 0, 0}, {0, -2, 0.3, 0}, {0, 0, 1, 0}, {3, 4, 5, 1}};
    const Mesh source = cube();
    const Scene scene = sceneOf(source, sheared);
    const Instance& instance = scene.instances().front();
    const Mesh& mesh = scene.meshes().at(instance.mesh);
    double farthest = 0.0;
    for (const glm::vec3 p : mesh.positions) {
        const glm::dvec3 world{instance.transform * glm::dvec4{mesh.origin + glm::dvec3{p}, 1.0}};
        const glm::dvec3 back{glm::inverse(sheared) * glm::dvec4{world, 1.0}};
        for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(std::abs(back[axis]) - 1.0));
    }
    EXPECT_LT(farthest, 1e-6);  // float rounding of corners at 1, carried back through the shear
}

TEST(Distortion, leavesMeshesOfRotatedMirroredAndEvenlyScaledInstancesShared) {
    Scene::Data data;
    data.meshes = {cube()};
    for (const double scale : {1.0, -2.0, 0.001}) {
        const glm::dmat4 turn = glm::rotate(unmoved, 0.7, glm::normalize(glm::dvec3{1, 2, 3}));
        data.instances.push_back({"", 0, turn * glm::scale(unmoved, glm::dvec3{scale})});
    }
    EXPECT_EQ(Scene{std::move(data)}.meshes().size(), 1U);
}

}  // namespace
}  // namespace inkedge

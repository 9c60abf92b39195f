// The patches of whole scenes: what the seams between their parts join.
#include "scene/prepared.h"

#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "mesh/topology.h"
#include "scenes.h"

namespace inkedge::scene {
namespace {

using testing::Each;
using testing::ElementsAre;

// One number a triangle of the scene, in the order of instances.
std::vector<std::uint32_t> numbersOf(const Scene& scene) {
    const PatchNumbers& patches = patchNumbersOf(scene);
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        for (const std::uint32_t p : topologyOf(scene, scene.instances()[i].mesh).patches) {
            numbers.push_back(patches.number[patches.base[i] + p]);
        }
    }
    return numbers;
}

// Two unit squares that meet at x = 0, the right one bent down by an angle, as meshes of their own.
const Mesh left = scenes::quad({-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0});
Mesh right(double degrees, double from = 0.0, double to = 1.0) {
    const double a = glm::radians(degrees);
    const glm::dvec3 out{std::cos(a), 0, -std::sin(a)};
    return scenes::quad({0, from, 0}, out + glm::dvec3{0, from, 0}, out + glm::dvec3{0, to, 0}, {0, to, 0});
}

glm::dmat4 identity() { return glm::dmat4{1.0}; }

Mesh merged(const std::vector<Mesh>& meshes) {
    Mesh all;
    for (const Mesh& mesh : meshes) {
        const auto offset = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const std::uint32_t i : mesh.indices) all.indices.push_back(offset + i);
    }
    return all;
}

Mesh woundBack(Mesh mesh) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
    for (glm::vec3& normal : mesh.normals) normal = -normal;
    return mesh;
}

Scene nodes(const Mesh& a, const Mesh& b, double creaseAngle = 30.0) {
    return scenes::sceneOf({{a, identity()}, {b, identity()}}, LoadSettings{Normals::Auto, Creases::Auto, creaseAngle});
}

TEST(Seams, joinNodesThatGoOnAtLessThanTheCreaseAngleOnly) {
    for (const double angle : {10.0, 30.0, 80.0}) {
        EXPECT_THAT(numbersOf(nodes(left, right(angle - 0.5), angle)), Each(1)) << angle;
        EXPECT_THAT(numbersOf(nodes(left, right(angle + 0.5), angle)), ElementsAre(1, 1, 2, 2)) << angle;
        EXPECT_THAT(numbersOf(nodes(left, right(-angle - 0.5), angle)), ElementsAre(1, 1, 2, 2)) << angle;
    }
}

TEST(Seams, doNotAskHowFacesAreWound) {
    EXPECT_THAT(numbersOf(nodes(left, woundBack(right(5.0)))), Each(1));
    EXPECT_THAT(numbersOf(nodes(woundBack(left), right(95.0))), ElementsAre(1, 1, 2, 2));
}

TEST(Seams, doNotJoinASheetFoldedBackOnItself) {
    EXPECT_THAT(numbersOf(nodes(left, right(179.0))), ElementsAre(1, 1, 2, 2));
}

TEST(Seams, sewTJunctions) {
    // The right side is split where the left one is not, within a mesh and between nodes.
    const Mesh split = merged({right(0.0, 0.0, 0.4), right(0.0, 0.4, 1.0)});
    EXPECT_THAT(numbersOf(scenes::sceneOf(merged({left, split}))), Each(1));
    EXPECT_THAT(numbersOf(nodes(left, split)), Each(1));
    const Mesh bent = merged({right(50.0, 0.0, 0.4), right(50.0, 0.4, 1.0)});
    EXPECT_THAT(numbersOf(scenes::sceneOf(merged({left, bent}))), ElementsAre(1, 1, 2, 2, 2, 2));
}

TEST(Seams, joinPartsThatOverlapAlongTheEdgeOnly) {
    EXPECT_THAT(numbersOf(nodes(left, right(0.0, 0.7, 1.7))), Each(1));
    EXPECT_THAT(numbersOf(nodes(left, right(0.0, 1.0, 2.0))), ElementsAre(1, 1, 2, 2)) << "touch in a corner";
}

TEST(Seams, bearTheRoundingOfCoordinatesButNoGap) {
    const auto moved = [&](double by) {
        return numbersOf(scenes::sceneOf({{left, identity()}, {right(0.0), scenes::translation({by, 0, 0})}}));
    };
    EXPECT_THAT(moved(1e-6), Each(1));
    EXPECT_THAT(moved(-1e-6), Each(1));
    EXPECT_THAT(moved(1e-3), ElementsAre(1, 1, 2, 2));  // half a pixel of a picture of 1024
}

TEST(Seams, areFoundWhereverTheNodesStand) {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const glm::dmat4 transform = scenes::translation({3e3 * scale, -2e3 * scale, 1e3 * scale}) *
                                     scenes::rotation(40, {1, 2, 3}) * scenes::scaling(glm::dvec3{scale});
        EXPECT_THAT(numbersOf(scenes::sceneOf({{left, transform}, {right(10.0), transform}})), Each(1)) << scale;
        EXPECT_THAT(numbersOf(scenes::sceneOf({{left, transform}, {right(40.0), transform}})), ElementsAre(1, 1, 2, 2))
            << scale;
    }
}

TEST(Seams, joinMirroredNodes) {
    // Two instances of one mesh, the second one mirrored: a symmetric part.
    const glm::dmat4 mirror = scenes::scaling({-1, 1, 1});
    EXPECT_THAT(numbersOf(scenes::sceneOf({{left, identity()}, {left, mirror}})), Each(1));
    Scene::Data data;
    data.meshes = {scenes::quad({-1, 0, -0.5}, {0, 0, 0}, {0, 1, 0}, {-1, 1, -0.5})};  // falls off by 27 degrees
    data.instances = {{"whole", 0, identity()}, {"mirrored", 0, mirror}};
    EXPECT_THAT(numbersOf(Scene{std::move(data)}), ElementsAre(1, 1, 2, 2)) << "a ridge of 53 degrees";
}

// Half of a prism's shell of so many sides, from one angle to another, with normals as of a cylinder.
Mesh halfShell(int sides, int from, int to) {
    Mesh mesh;
    for (int i = from; i <= to; ++i) {
        const double a = glm::radians(360.0 * i / sides);
        for (const double y : {0.0, 1.0}) {
            mesh.positions.emplace_back(glm::dvec3{std::cos(a), y, std::sin(a)});
            mesh.normals.emplace_back(glm::dvec3{std::cos(a), 0.0, std::sin(a)});
        }
    }
    for (std::uint32_t i = 0; i + 3 < mesh.positions.size(); i += 2)
        for (const std::uint32_t c : {0U, 1U, 2U, 2U, 1U, 3U}) mesh.indices.push_back(i + c);
    return mesh;
}

Mesh withNormalsAlong(Mesh mesh, glm::vec3 turned) {
    for (glm::vec3& normal : mesh.normals) normal = glm::normalize(normal + turned);
    return mesh;
}

TEST(Seams, joinShellsWhoseNormalsGoOnUpToTwiceTheCreaseAngle) {
    const glm::dmat4 half = scenes::rotation(180.0, {0, 1, 0});
    const glm::dmat4 mirror = scenes::scaling({1, 1, -1});
    const auto patches = [&](const Mesh& a, const Mesh& b, const glm::dmat4& to, const LoadSettings& settings) {
        return patchNumbersOf(scenes::sceneOf({{a, identity()}, {b, to}}, settings)).count;
    };
    const LoadSettings by30{Normals::Auto, Creases::Auto, 30.0};
    const Mesh shell = halfShell(8, 0, 4);  // bends by 45 degrees
    EXPECT_EQ(patches(shell, shell, half, by30), 1U);
    EXPECT_EQ(patches(shell, woundBack(shell), half, by30), 1U);
    EXPECT_EQ(patches(shell, shell, mirror, by30), 1U);
    EXPECT_EQ(patches(shell, halfShell(8, 4, 8), identity(), by30), 1U);
    EXPECT_EQ(patches(shell, shell, half, {Normals::Auto, Creases::Angle, 30.0}), 8U);
    EXPECT_EQ(patches(shell, shell, half, {Normals::Auto, Creases::Normals, 30.0}), 1U);
    EXPECT_EQ(patches(shell, shell, half, {Normals::Flat, Creases::Auto, 30.0}), 8U);
    EXPECT_EQ(patches(shell, withNormalsAlong(shell, {0, 0.2, 0}), half, by30), 2U) << "normals split by 11 degrees";
    EXPECT_EQ(patches(shell, shell, half, {Normals::Auto, Creases::Auto, 20.0}), 8U) << "over twice the angle";
}

TEST(Seams, leaveEdgesOfThreeFacesApart) {
    const Mesh fin = scenes::quad({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0});
    EXPECT_THAT(numbersOf(scenes::sceneOf(merged({left, right(0.0), fin}))), ElementsAre(1, 1, 2, 2, 3, 3));
}

TEST(Seams, leaveClosedBodiesThatTouchApart) {
    const Scene scene =
        scenes::sceneOf({{scenes::cube(), identity()}, {scenes::cube(), scenes::translation({2, 0, 0})}});
    EXPECT_EQ(patchNumbersOf(scene).count, 12U);
}

TEST(PatchNumbers, countEachInstanceAnew) {
    Scene::Data data;
    data.meshes = {scenes::cube()};
    for (int i = 0; i < 3; ++i) data.instances.push_back({"cube", 0, scenes::translation({5.0 * i, 0, 0})});
    const Scene scene{std::move(data)};
    EXPECT_THAT(patchNumbersOf(scene).base, ElementsAre(0, 6, 12));
    EXPECT_EQ(patchNumbersOf(scene).count, 18U);
    const std::vector<std::uint32_t> numbers = numbersOf(scene);
    EXPECT_EQ(std::set<std::uint32_t>(numbers.begin(), numbers.end()).size(), 18U);
    EXPECT_EQ(*std::ranges::min_element(numbers), 1U);
}

TEST(PatchNumbers, takeBothSidesOfATwoSidedFaceAsOne) {
    // Each face twice, back to back, as exporters write two-sided materials.
    const Mesh sheet = merged({left, right(10.0)});
    EXPECT_THAT(numbersOf(scenes::sceneOf(merged({sheet, woundBack(sheet)}))), Each(1));
    EXPECT_THAT(patchNumbersOf(scenes::sceneOf(merged({sheet, woundBack(sheet)}))).layered, Each(false));
}

TEST(PatchNumbers, areThoseOfTheWorldsAngles) {
    // A roof of 20 degrees in its mesh, 72 once its height is stretched tenfold; and one that a scale flattens.
    const double rise = std::tan(glm::radians(10.0));
    const auto roof = [](double h) {
        Mesh mesh;
        for (const glm::dvec3& p : {glm::dvec3{-1, 0, 0}, {0, 0, h}, {0, 1, h}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}}) {
            mesh.positions.emplace_back(p);
        }
        mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
        return mesh;
    };
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(rise))), Each(1));
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(rise), scenes::scaling({1, 1, 4}))), ElementsAre(1, 1, 2, 2));
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(4 * rise), scenes::scaling({1, 1, 0.25}))), Each(1));
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(4 * rise), scenes::scaling({7, 7, 7}))), ElementsAre(1, 1, 2, 2));
    // Sheared along the fold's fall, its sides bend by another angle: x += 3 z turns one side under the other.
    glm::dmat4 shear{1.0};
    shear[2] = {3.0, 0.0, 1.0, 0.0};
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(rise))), Each(1));
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(4 * rise), scenes::rotation(30, {1, 2, 0}) * shear)),
                ElementsAre(1, 1, 2, 2));
    shear[2] = {0.0, 5.0, 1.0, 0.0};  // along the fold: nothing but the bend in a plane across it counts
    EXPECT_THAT(numbersOf(scenes::sceneOf(roof(rise), shear)), Each(1));
}

}  // namespace
}  // namespace inkedge::scene

#include <inkedge/scene.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "mesh/topology.h"
#include "scene/extent.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::scene {
namespace {

using testing::IsEmpty;
using testing::StrEq;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double exact = 1e-12;  // sums and products of a few doubles of order 1

Scene::Data cubeData() {
    Scene::Data data;
    data.meshes.push_back(scenes::cube());
    data.meshes.back().name = "part";
    data.instances.push_back({"instance", 0, glm::dmat4{1.0}});
    return data;
}

void expectRefusal(const Scene::Data& data, const std::string& message) {
    expectError(Error::Kind::Input, StrEq(message), [&] { Scene{data}; });
}

void expectNear(glm::dvec3 found, glm::dvec3 expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], exact) << "component " << i;
}

TEST(Scene, refusesAnOriginThatIsNotFinite) {
    auto data = cubeData();
    data.meshes[0].origin.y = nan;
    expectRefusal(data, "mesh 0 'part': expected a finite origin, found one that is not");
}

TEST(Scene, refusesIndicesThatAreNoTriangles) {
    auto data = cubeData();
    data.meshes[0].indices.pop_back();
    expectRefusal(data, "mesh 0 'part': expected three indices a triangle, found 35 indices");
}

TEST(Scene, refusesKindsOfEdgesThatAreNotOneAnIndex) {
    auto data = cubeData();
    data.meshes[0].edges.resize(7);
    expectRefusal(data, "mesh 0 'part': expected 36 kinds of edges, one an index, found 7");
}

TEST(Scene, refusesFacesThatAreNotOneATriangle) {
    auto data = cubeData();
    data.meshes[0].faces.resize(7);
    expectRefusal(data, "mesh 0 'part': expected 12 faces, one a triangle, found 7");
}

TEST(Scene, refusesNodesThatAreNoTree) {
    auto data = cubeData();
    data.nodes = {{"a"}, {"b", 1}};
    expectRefusal(data, "node 1 'b': expected a parent before it, found 1");
    data.nodes = {{"a"}, {"b", 0}};
    data.instances[0].node = 2;
    expectRefusal(data, "instance 0 'instance': expected a node below 2, found 2");
}

TEST(Scene, refusesNormalsThatAreNotOneAPosition) {
    auto data = cubeData();
    data.meshes[0].normals.resize(7);
    expectRefusal(data, "mesh 0 'part': expected 8 normals, one a position, found 7");
}

TEST(Scene, refusesPositionsThatAreNotFinite) {
    auto data = cubeData();
    data.meshes[0].positions[3] = {1, nan, 2};
    expectRefusal(data, "mesh 0 'part': expected finite positions, found vertex 3 at (1, nan, 2)");
    data.meshes[0].positions[3] = {1, 0, -infinity};
    expectRefusal(data, "mesh 0 'part': expected finite positions, found vertex 3 at (1, 0, -inf)");
}

TEST(Scene, refusesIndicesOutOfRange) {
    auto data = cubeData();
    data.meshes[0].indices[7] = 8;
    expectRefusal(data, "mesh 0 'part': expected indices below 8, found 8 at 7");
}

TEST(Scene, namesTheMeshThatIsWrong) {
    auto data = cubeData();
    data.meshes.push_back(scenes::cube());
    data.meshes[1].name = "other";
    data.meshes[1].indices[0] = 4000000000U;
    expectRefusal(data, "mesh 1 'other': expected indices below 8, found 4000000000 at 0");
}

TEST(Scene, refusesInstancesOfNoMesh) {
    auto data = cubeData();
    data.instances.push_back({"lost", 1, glm::dmat4{1.0}});
    expectRefusal(data, "instance 1 'lost': expected a mesh below 1, found 1");
}

TEST(Scene, refusesTransformsThatAreNotFinite) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            auto data = cubeData();
            data.instances[0].transform[column][row] = infinity;
            expectRefusal(data, "instance 0 'instance': expected a finite transform, found one that is not");
        }
    }
}

TEST(Scene, refusesToDrawNothing) {
    expectRefusal({}, "expected at least one triangle or line to draw, found none");
    auto data = cubeData();
    data.instances.clear();
    expectRefusal(data, "expected at least one triangle or line to draw, found none");
    data = cubeData();
    data.meshes[0].indices.clear();
    expectRefusal(data, "expected at least one triangle or line to draw, found none");
}

TEST(Scene, saysWhatThereIsInstead) {
    Scene::Data data;
    data.undrawn = {"8 points", "1 mesh in hidden nodes"};
    expectRefusal(data, "expected at least one triangle or line to draw, found none: 8 points, 1 mesh in hidden nodes");
}

TEST(Scene, isBoundedWithoutInstancesOfNoExtent) {
    const Scene alone{cubeData()};
    for (const glm::dmat4& rotation : {glm::dmat4{1.0}, scenes::rotation(30, {1, 2, 3})}) {
        auto data = cubeData();
        data.instances.push_back(
            {"shrunk", 0, scenes::translation({20, -30, 5}) * rotation * scenes::scaling(glm::dvec3{0.0})});
        const Scene scene{data};
        EXPECT_EQ(scene.box().min, alone.box().min);
        EXPECT_EQ(scene.box().max, alone.box().max);
        EXPECT_EQ(scene.bounds().radius, alone.bounds().radius);
        EXPECT_EQ(support(scene, {1, 0, 0}), support(alone, {1, 0, 0}));
        data.instances.erase(data.instances.begin());
        EXPECT_EQ(Scene{data}.box().min, glm::dvec3(20, -30, 5)) << "if none has one, all count";
        data.instances[0].transform = scenes::translation({20, 0, 0}) * scenes::scaling({0.0, 1.0, 1.0});
        data.instances.push_back({"cube", 0, glm::dmat4{1.0}});
        EXPECT_EQ(Scene{data}.box().max.x, 20.0) << "a flat one has an extent";
    }
}

TEST(Scene, refusesBoundsThatOverflow) {
    auto data = cubeData();
    data.instances[0].transform = scenes::scaling(glm::dvec3{1e200});
    expectRefusal(data, "mesh 'part': expected finite positions, found a transform that takes them out of range");
    data.instances[0].transform = scenes::translation({1e308, 0, 0});
    data.instances.push_back({"other", 0, scenes::translation({-1e308, 0, 0})});
    expectRefusal(data, "expected finite bounds, found coordinates that overflow");
}

TEST(Scene, leavesOutInstancesWithoutTriangles) {
    auto data = cubeData();
    data.meshes.emplace_back();
    data.instances.push_back({"empty", 1, scenes::translation({1000, 0, 0})});
    const Scene scene{data};
    ASSERT_EQ(scene.instances().size(), 1U);
    EXPECT_EQ(scene.instances()[0].name, "instance");
    EXPECT_EQ(scene.triangleCount(), 12U);
    EXPECT_NEAR(scene.bounds().radius, std::sqrt(3.0), exact);
}

TEST(Scene, givesEveryMeshUnitNormals) {
    const Scene scene{cubeData()};
    ASSERT_EQ(scene.meshes()[0].normals.size(), scene.meshes()[0].positions.size());
    EXPECT_EQ(scene.meshes()[0].normals.size(), 24U);
    LoadSettings smooth;
    smooth.creaseAngle = 180.0;
    EXPECT_EQ(Scene(cubeData(), smooth).meshes()[0].normals.size(), 8U);
}

TEST(Scene, knowsHowLongItTookToPrepare) {
    const auto begin = std::chrono::steady_clock::now();
    const Scene scene{cubeData()};
    const std::chrono::duration<double, std::milli> limit = std::chrono::steady_clock::now() - begin;
    EXPECT_GT(scene.preparationMilliseconds(), 0.0);
    EXPECT_LE(scene.preparationMilliseconds(), limit.count());
}

TEST(Scene, countsTheTrianglesOfEveryInstance) {
    auto data = cubeData();
    data.instances.push_back({"second", 0, glm::dmat4{1.0}});
    data.instances.push_back({"third", 0, glm::dmat4{1.0}});
    EXPECT_EQ(Scene{data}.triangleCount(), 36U);
}

TEST(Scene, boxesMeshesInTheirOwnSpaceLessTheOrigin) {
    auto data = cubeData();
    data.meshes[0].origin = {1e6, 0, 0};
    data.instances[0].transform = scenes::rotation(45, {0, 1, 0});
    const Scene scene{data};
    const Box& box = scene.meshBox(0);
    EXPECT_EQ(box.min, glm::dvec3(-1.0));
    EXPECT_EQ(box.max, glm::dvec3(1.0));
}

TEST(Scene, keepsNoMemoryForFaceNormals) {
    const Scene scene = scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}});
    EXPECT_EQ(topologyOf(scene, 0).faceNormals.capacity(), 0U);
}

TEST(SceneBounds, addTheMeshesOrigin) {
    auto data = cubeData();
    data.meshes[0].origin = {1e6, 2e6, -3e6};
    data.instances[0].transform = scenes::scaling({2, 2, 2});
    const Scene scene{data};
    EXPECT_NEAR(scene.bounds().centre.x, 2e6, 1e-6);
    EXPECT_NEAR(scene.bounds().centre.z, -6e6, 1e-6);
    EXPECT_NEAR(scene.bounds().radius, 2.0 * std::sqrt(3.0), 1e-6);  // doubles of order 1e6: 1e-9 each
}

// The middle of the world's axis-aligned box around all vertices, and the distance of the farthest vertex from there.
Sphere expectedBounds(const Scene& scene) {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high = -low;
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    Sphere sphere{0.5 * (low + high), 0.0};
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre));
    }
    return sphere;
}

TEST(SceneBounds, areThoseOfTheVerticesUnderAnyTransform) {
    glm::dmat4 shear{1.0};
    shear[1][0] = 1.5;
    shear[2][1] = -0.5;
    const glm::dmat4 moved = scenes::translation({3, -1, 2});
    for (const glm::dmat4& transform :
         {moved, moved * scenes::rotation(33, {1, 2, 3}), moved * scenes::scaling({-1, 1, 1}),
          moved * scenes::scaling({-2, 0.5, -3}) * scenes::rotation(70, {0, 1, 1}), moved * shear,
          moved * shear * scenes::scaling({1, -1, 1}), moved * scenes::scaling({1, 0, 1})}) {
        // A sphere off its box's centre: a box of transformed corners would be too large.
        const Scene scene =
            scenes::sceneOf({{scenes::sphere(1.0, 16), transform}, {scenes::cube(0.1), glm::dmat4{1.0}}});
        const Sphere expected = expectedBounds(scene);
        expectNear(scene.bounds().centre, expected.centre);
        EXPECT_NEAR(scene.bounds().radius, expected.radius, exact);
    }
}

TEST(SceneBounds, takeInEveryInstance) {
    auto data = cubeData();
    data.instances.push_back({"far", 0, scenes::translation({10, 0, 0}) * scenes::scaling({-1, 1, 1})});
    const Scene scene{data};
    expectNear(scene.bounds().centre, {5, 0, 0});
    EXPECT_NEAR(scene.bounds().radius, std::sqrt(38.0), exact);
}

TEST(SceneOfLines, RefusesHalvesOfPiecesAndPositionsThatAreNotFinite) {
    Scene::Data data;
    data.meshes.resize(1);
    data.instances.push_back({"wire", 0, glm::dmat4{1.0}});
    data.meshes[0].lines = {{0, 0, 0}};
    expectError(Error::Kind::Input, testing::HasSubstr("expected two positions a piece of a line, found 1 positions"),
                [&] { Scene{data}; });
    data.meshes[0].lines = {{0, 0, 0}, {0, std::numeric_limits<float>::infinity(), 0}};
    expectError(Error::Kind::Input, testing::HasSubstr("expected finite positions of lines, found position 1"),
                [&] { Scene{data}; });
}

TEST(SceneOfLines, CountsTheLinesOfAllInstancesForItsLimit) {
    Scene::Data data;
    data.meshes.resize(1);
    data.meshes[0].lines = {{0, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 3; ++i) data.instances.push_back({"wire", 0, glm::dmat4{1.0}});
    LoadSettings settings;
    settings.limits.vertices = 6;
    EXPECT_EQ((Scene{data, settings}.box().max), (glm::dvec3{1, 0, 0}));
    settings.limits.vertices = 5;
    expectError(Error::Kind::Input,
                testing::StrEq("expected at most 5 ends of lines in all instances, found more; raise max-vertices"),
                [&] {
                    Scene{data, settings};
                });
}

// glTF primitives often share one vertex array and use a part of it each.
TEST(SceneBounds, leaveOutVerticesThatNoTriangleUses) {
    for (const bool withNormals : {false, true}) {
        auto data = cubeData();
        Mesh& mesh = data.meshes[0];
        mesh.positions.insert(mesh.positions.begin(), {1000, 1000, 1000});
        for (std::uint32_t& i : mesh.indices) ++i;
        if (withNormals) mesh.normals.assign(mesh.positions.size(), glm::vec3{0, 0, 1});
        const Scene scene{data};
        expectNear(scene.bounds().centre, {0, 0, 0});
        EXPECT_NEAR(scene.bounds().radius, std::sqrt(3.0), exact);
        EXPECT_EQ(scene.meshBox(0).max, glm::dvec3(1.0));
    }
}

TEST(Support, isTheFarthestReachAlongADirection) {
    const Scene scene =
        scenes::sceneOf(scenes::cube(), scenes::translation({5, 0, 0}) * scenes::rotation(45, {0, 0, 1}));
    EXPECT_NEAR(support(scene, {1, 0, 0}), 5.0 + std::sqrt(2.0), exact);
    EXPECT_NEAR(support(scene, {-1, 0, 0}), -5.0 + std::sqrt(2.0), exact);
    EXPECT_NEAR(support(scene, {0, 0, 3}), 3.0, exact);
    const PreparedScene& prepared = *preparedOf(scene);
    const InstancedBoxes boxes{prepared.data.meshes, prepared.meshBoxes, prepared.data.instances};
    EXPECT_NEAR(farthestDistance(boxes, {5, 0, 0}), std::sqrt(3.0), exact);
}

TEST(SceneIdentity, isSharedByCopiesAndByNoOtherScene) {
    const Scene scene{cubeData()};
    const Scene copy = scene;
    const Scene twin{cubeData()};
    EXPECT_EQ(identityOf(scene).lock(), identityOf(copy).lock());
    EXPECT_NE(identityOf(scene).lock(), identityOf(twin).lock());
}

TEST(SceneIdentity, endsWithTheLastCopy) {
    std::weak_ptr<const void> identity;
    {
        const Scene copy = [&] {
            const Scene scene{cubeData()};
            identity = identityOf(scene);
            return scene;
        }();
        EXPECT_FALSE(identity.expired());
    }
    EXPECT_TRUE(identity.expired());
}

TEST(Scene, keepsCamerasAndWarnings) {
    auto data = cubeData();
    data.cameras.push_back({"eye", glm::dmat4{1.0}, 40.0, 0.0});
    data.warnings = {"points are not drawn"};
    const Scene scene{data};
    ASSERT_EQ(scene.cameras().size(), 1U);
    EXPECT_EQ(scene.cameras()[0].viewAngle, 40.0);
    EXPECT_THAT(scene.warnings(), testing::ElementsAre("points are not drawn"));
}

}  // namespace
}  // namespace inkedge::scene

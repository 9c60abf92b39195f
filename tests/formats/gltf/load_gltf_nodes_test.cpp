#include "formats/gltf/load_gltf.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "formats/gltf/gltf_files.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using LoadGltf = GltfFileTest;

// ---- nodes

TEST_F(LoadGltf, multipliesTransformsDownTheTree) {
    Model model;
    const int mesh = model.mesh(positions(model.accessor<float>({1, 2, 3, 0, 0, 0, 0, 1, 0}, "VEC3")));
    const double s = std::sqrt(0.5);
    model.root({{"translation", {10, 0, 0}},
                {"rotation", {0, 0, 2 * s, 2 * s}},
                {"scale", {2, 3, -4}},
                {"children", {1}}});  // the rotation's length is 2: a quarter turn about z
    model.add("nodes", {{"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1}}, {"mesh", mesh}});
    // The child shears x by y/2 and moves z by 1: (1, 2, 3) -> (2, 2, 4); the root scales: (4, 6, -16); turns: (-6, 4,
    // -16).
    const std::vector<glm::dvec3> corners = worldCorners(load(model));
    expectNear(corners, {{4, 4, -16}, {10, 0, -4}, {7, 1, -4}}, 1e-5);
}

TEST_F(LoadGltf, drawsAMeshOnceForEachNode) {
    Model model = indexedTriangle();
    model.root({{"mesh", 0}, {"translation", {0, 0, 7}}});
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes, SizeIs(1));
    ASSERT_THAT(data.instances, SizeIs(2));
    EXPECT_EQ(data.instances[0].name, "wheel");
    EXPECT_EQ(data.instances[1].name, "gear");
    EXPECT_EQ(data.instances[1].transform[3].z, 7.0);
}

TEST_F(LoadGltf, keepsTheTreeOfPartsWithItsNames) {
    Model model = triangle();
    model.json["nodes"] = Json::array();
    model.add("nodes", {{"name", "bolt"}, {"mesh", 0}});
    model.add("nodes", {{"name", "machine"}, {"children", {2, 0}}});
    model.add("nodes", {{"children", {3}}});
    model.add("nodes", {{"name", "axle"}, {"mesh", 0}});
    model.json["scenes"][0]["nodes"] = {1};
    const Scene scene{load(model)};
    std::vector<std::string> paths;
    for (const Instance& instance : scene.instances()) {
        paths.emplace_back();
        for (std::uint32_t node = instance.node; node != noNode; node = scene.nodes().at(node).parent)
            paths.back() += "/" + scene.nodes()[node].name;
    }
    EXPECT_THAT(paths, ElementsAre("/axle//machine", "/bolt/machine"));
}

TEST_F(LoadGltf, followsChainsOfAHundredThousandNodes) {
    constexpr int length = 100'000;
    Model model = triangle();
    model.json["nodes"] = Json::array();
    for (int i = 0; i < length; ++i) {
        Json node{{"translation", {1, 0, 0}}};
        if (i + 1 < length) node["children"] = {i + 1};
        if (i + 1 == length) node["mesh"] = 0;
        model.add("nodes", node);
    }
    EXPECT_EQ(load(model).instances.at(0).transform[3].x, length);
}

TEST_F(LoadGltf, drawsTheDefaultSceneElseTheFirstElseEveryNode) {
    Model model = indexedTriangle();
    model.add("nodes", {{"mesh", 0}, {"name", "second"}});
    model.add("scenes", {{"nodes", {1}}});
    const auto names = [&] {
        std::vector<std::string> all;
        for (const Instance& instance : load(model).instances) all.push_back(instance.name);
        return all;
    };
    EXPECT_THAT(names(), ElementsAre("wheel"));
    model.json["scene"] = 1;
    EXPECT_THAT(names(), ElementsAre("second"));
    model.json.erase("scene");
    model.json.erase("scenes");
    EXPECT_THAT(names(), ElementsAre("wheel", "second"));
}

TEST_F(LoadGltf, leavesASceneWithoutTrianglesEmpty) {
    Model model;
    EXPECT_THAT(load(model).instances, IsEmpty());
    model = triangle();
    model.json["nodes"][0].erase("mesh");
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes, IsEmpty());
    EXPECT_THAT(data.instances, IsEmpty());
}

TEST_F(LoadGltf, drawsEveryCopyOfAnInstancedMesh) {
    Model model = triangle();
    const Json attributes{{"TRANSLATION", model.accessor<float>({1, 0, 0, 0, 2, 0}, "VEC3")},
                          {"ROTATION", model.accessor<std::int8_t>({0, 0, 0, 127, 0, 0, 127, 0}, "VEC4")},
                          {"SCALE", model.accessor<float>({1, 1, 1, 2, 2, 2}, "VEC3")}};
    model.json["accessors"][2]["normalized"] = true;
    model.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    model.json["nodes"][0]["translation"] = {0, 0, 5};
    model.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    expectNear(worldCorners(load(model)), {{1, 0, 5}, {2, 0, 5}, {1, 1, 5}, {0, 2, 5}, {-2, 2, 5}, {0, 0, 5}});
}

TEST_F(LoadGltf, drawsAMeshOnceWhoseInstancesHaveNoAttributes) {
    for (const Json& extension : {Json::array({1, 2}), Json{{"attributes", {1, 2}}}, Json{{"attributes", nullptr}}}) {
        Model model = triangle();
        model.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = extension;
        EXPECT_THAT(load(model).instances, SizeIs(1)) << extension;
    }
}

// ---- poses

TEST_F(LoadGltf, movesMorphTargetsByTheNodesWeightsElseTheMeshs) {
    Model model = indexedTriangle();
    Json& primitive = model.json["meshes"][0]["primitives"][0];
    const int up = model.accessor<float>({0, 0, 0, 0, 0, 0, 0, 1, 0}, "VEC3");
    const int toX = model.accessor<float>({1, 0, -1, 1, 0, -1, 1, 0, -1}, "VEC3");
    primitive["attributes"]["NORMAL"] = model.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    primitive["targets"] = {{{"POSITION", up}}, {{"NORMAL", toX}}};
    model.json["meshes"][0]["weights"] = {2, 0};
    model.root({{"mesh", 0}, {"weights", {0.5, 1}}});
    model.root({{"mesh", 0}, {"weights", {0, 0}}});
    const Scene::Data data = load(model);
    ASSERT_THAT(data.instances, SizeIs(3));
    ASSERT_THAT(data.meshes, SizeIs(3));
    EXPECT_EQ(position(data.meshes[0], 2).y, 3.0);
    EXPECT_EQ(position(data.meshes[1], 2).y, 1.5);
    EXPECT_EQ(position(data.meshes[2], 2).y, 1.0);
    EXPECT_EQ(data.meshes[0].normals.at(0), (glm::vec3{0, 0, 1}));
    EXPECT_EQ(data.meshes[1].normals.at(0), (glm::vec3{1, 0, 0}));
}

TEST_F(LoadGltf, sharesAMeshBetweenNodesOfTheSameMorphWeights) {
    Model model = indexedTriangle();
    Json& primitive = model.json["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", primitive["attributes"]["POSITION"]}}};
    model.json["nodes"][0]["weights"] = {1};
    model.root({{"mesh", 0}, {"weights", {1}}});
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes, SizeIs(1));
    EXPECT_THAT(data.instances, SizeIs(2));
}

// A triangle on two joints: joint 0 lifts by 10, joint 1 mirrors x; vertex 2 hangs on both.
Model skinnedTriangle() {
    Model model = indexedTriangle();
    Json& attributes = model.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = model.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] = model.accessor<float>({1, 0, 0, 0, 2, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
    attributes["NORMAL"] = model.accessor<float>({0, 0, 1, 1, 0, 0, 0, 0, 1}, "VEC3");
    const int inverses = model.accessor<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1,  //
                                                1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,  1},
                                               "MAT4");
    const int lift = model.root({{"translation", {0, 0, 11}}});
    const int mirror = model.add("nodes", {{"scale", {-1, 1, 1}}});
    model.add("skins", {{"joints", {lift, mirror}}, {"inverseBindMatrices", inverses}});
    model.json["nodes"][0]["skin"] = 0;
    model.json["nodes"][0]["translation"] = {100, 100, 100};  // does not count
    return model;
}

TEST_F(LoadGltf, drawsSkinsInTheirDefaultPose) {
    const Scene::Data data = load(skinnedTriangle());
    expectNear(worldCorners(data), {{0, 0, 10}, {-1, 0, 0}, {0, 1, 5}});
    EXPECT_EQ(data.meshes.at(0).normals.at(0), (glm::vec3{0, 0, 1}));
    EXPECT_EQ(data.meshes.at(0).normals.at(1), (glm::vec3{-1, 0, 0}));
}

TEST_F(LoadGltf, takesMissingInverseBindMatricesForIdentity) {
    Model model = skinnedTriangle();
    model.json["skins"][0].erase("inverseBindMatrices");
    expectNear(worldCorners(load(model)), {{0, 0, 11}, {-1, 0, 0}, {0, 1, 5.5}});
}

TEST_F(LoadGltf, refusesSkinsThatDoNotFit) {
    Model model = skinnedTriangle();
    model.json["skins"][0]["joints"] = {1};
    EXPECT_THAT(refusal(model), HasSubstr("JOINTS_0: expected joints below 1, found 1"));
    model.json["skins"][0]["joints"] = {1, 77};
    EXPECT_THAT(refusal(model), HasSubstr("skin 0: expected a joint node below 3, found 77"));
    model.json["skins"][0]["joints"] = {1, 2, 2};
    EXPECT_THAT(refusal(model), HasSubstr("expected an inverse bind matrix for each of 3 joints, found 2"));
    model = skinnedTriangle();
    model.json["nodes"][0]["skin"] = 4;
    EXPECT_THAT(refusal(model), HasSubstr("node 0 'wheel': expected a skin below 1, found 4"));
    model = skinnedTriangle();
    model.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
    EXPECT_THAT(refusal(model), HasSubstr("expected JOINTS_0 and WEIGHTS_0"));
}

// ---- cameras

TEST_F(LoadGltf, readsCamerasInTheOrderOfTheScene) {
    Model model = triangle();
    model.add("cameras", {{"type", "perspective"}, {"name", "lens"}, {"perspective", {{"yfov", 1.0}, {"znear", 1}}}});
    model.add("cameras",
              {{"type", "orthographic"}, {"orthographic", {{"xmag", 9}, {"ymag", 2.5}, {"znear", 0}, {"zfar", 9}}}});
    model.root({{"camera", 1}, {"name", "flat"}});
    model.root({{"camera", 0}, {"translation", {1, 2, 3}}});
    const Scene::Data data = load(model);
    ASSERT_THAT(data.cameras, SizeIs(2));
    EXPECT_EQ(data.cameras[0].name, "flat");
    EXPECT_EQ(data.cameras[0].orthographicHeight, 5.0);
    EXPECT_EQ(data.cameras[1].name, "lens");
    EXPECT_EQ(data.cameras[1].orthographicHeight, 0.0);
    EXPECT_NEAR(data.cameras[1].viewAngle, 57.29577951308232, 1e-9);
    EXPECT_EQ(glm::dvec3{data.cameras[1].transform[3]}, (glm::dvec3{1, 2, 3}));
}

TEST_F(LoadGltf, makesCameraTransformsRigid) {
    Model model = triangle();
    model.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 1}}}});
    model.root({{"camera", 0}, {"matrix", {-2, 0, 0, 0, 0.7, 3, 0.5, 0, 0, 1, -4, 0, 5, 6, 7, 1}}});
    const glm::dmat4 transform = load(model).cameras.at(0).transform;
    const glm::dmat3 axes{transform};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::dot(axes[i], axes[k]), i == k ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
    EXPECT_LE(glm::length(axes[2] - glm::normalize(glm::dvec3{0, 1, -4})), 1e-12);
    EXPECT_EQ(glm::dvec3{transform[3]}, (glm::dvec3{5, 6, 7}));
}

TEST_F(LoadGltf, leavesOutUnusableCamerasWithAWarning) {
    Model model = triangle();
    model.add("cameras", {{"type", "perspective"}, {"name", "wide"}, {"perspective", {{"yfov", 4}, {"znear", 1}}}});
    model.root({{"camera", 0}});
    const Scene::Data data = load(model);
    EXPECT_THAT(data.cameras, IsEmpty());
    EXPECT_THAT(data.warnings, ElementsAre("camera 0 'wide' is left out: expected a yfov between 0 and pi, found 4"));
}

}  // namespace
}  // namespace inkedge::gltf

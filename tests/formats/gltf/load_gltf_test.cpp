#include "formats/gltf/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>

#include "formats/gltf/compression.h"
#include "formats/gltf/gltf_files.h"

namespace inkedge {
namespace {

using namespace gltf_files;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

using LoadGltf = GltfFileTest;

// ---- containers

TEST_F(LoadGltf, tellsGlbFromGltfByContent) {
    for (const char* name : {"a.gltf", "a.glb", "a.data"}) {
        expectNear(worldCorners(loadGltf({write(name, triangle().gltf())})), triangleCorners);
        expectNear(worldCorners(loadGltf({write(name, triangle().glb())})), triangleCorners);
    }
}

TEST_F(LoadGltf, readsJsonChunksPaddedWithZeros) {
    Model model = triangle();
    while (model.glb() == model.glb('\0')) model.json["asset"]["generator"] = model.json["asset"].dump();
    expectNear(worldCorners(loadGltf({write("a.glb", model.glb('\0'))})), triangleCorners);
}

TEST_F(LoadGltf, readsExternalBuffersBesideAndBelowTheModel) {
    Model model = triangle();
    const std::string content{model.bytes.begin(), model.bytes.end()};
    static_cast<void>(write("Zähler 1+2%.bin", content));
    static_cast<void>(write("below/b.bin", content));
    for (const char* uri : {"Z%C3%A4hler%201+2%25.bin", "Zähler 1+2%25.bin", "below/b.bin", "./below/../below/b.bin"}) {
        model.json["buffers"] = {{{"byteLength", model.bytes.size()}, {"uri", uri}}};
        expectNear(worldCorners(load(model)), triangleCorners);
    }
}

TEST_F(LoadGltf, readsUnicodePathsAndKeepsUnicodeNames) {
    Model model = triangle();
    model.json["meshes"][0]["name"] = "歯車";
    model.json["nodes"][0]["name"] = "Prüfplatte";
    const Scene::Data data = loadGltf({write("Ordner ü/歯車 🦷.glb", model.glb())});
    EXPECT_EQ(data.meshes.at(0).name, "歯車");
    EXPECT_EQ(data.instances.at(0).name, "Prüfplatte");
}

TEST_F(LoadGltf, readsAModelNamedRelativeToTheCurrentFolder) {
    Model model = triangle();
    static_cast<void>(write("b.bin", {model.bytes.begin(), model.bytes.end()}));
    model.json["buffers"] = {{{"byteLength", model.bytes.size()}, {"uri", "b.bin"}}};
    static_cast<void>(write("model.gltf", model.gltf()));
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    const Scene::Data data = loadGltf({"model.gltf"});
    fs::current_path(before);
    expectNear(worldCorners(data), triangleCorners);
}

TEST_F(LoadGltf, readsIntegersThatAreWrittenWithAFraction) {
    Model model;
    model.bufferView<float>({9, 9, 9});
    const int position = model.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    model.root({{"mesh", model.mesh(positions(position))}});
    model.json["bufferViews"][1]["byteOffset"] = 12.0;
    ASSERT_THAT(model.gltf(), HasSubstr("12.0"));
    expectNear(worldCorners(load(model)), triangleCorners);
}

// ---- primitives

struct ModeCase {
    int mode;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> triangles;
};

TEST_F(LoadGltf, turnsEveryTriangleModeIntoTrianglesOfTheWindingThatGltfPrescribes) {
    const std::vector<ModeCase> cases{
        {4, {0, 1, 2, 2, 1, 3}, {0, 1, 2, 2, 1, 3}},
        {5, {0, 1, 2, 3}, {0, 1, 2, 1, 3, 2}},
        {5, {3, 2, 1, 0, 2}, {3, 2, 1, 2, 0, 1, 1, 0, 2}},
        {6, {0, 1, 3, 2}, {1, 3, 0, 3, 2, 0}},
        {5, {0, 1}, {}},
        {6, {0, 1}, {}},
    };
    for (const ModeCase& wanted : cases) {
        Model model;
        Json primitive = positions(model.accessor(square, "VEC3"));
        primitive["mode"] = wanted.mode;
        primitive["indices"] = model.accessor(wanted.indices, "SCALAR");
        model.root({{"mesh", model.mesh(primitive)}});
        const Scene::Data data = load(model);
        EXPECT_EQ(data.meshes.empty() ? std::vector<std::uint32_t>{} : data.meshes[0].indices, wanted.triangles)
            << "mode " << wanted.mode;
    }
}

TEST_F(LoadGltf, turnsStripsIntoTrianglesOfTheSameWinding) {
    Model model;
    Json primitive = positions(model.accessor(square, "VEC3"));
    primitive["mode"] = 5;
    model.root({{"mesh", model.mesh(primitive)}});
    const std::vector<glm::dvec3> corners = worldCorners(load(model));
    ASSERT_THAT(corners, SizeIs(6));
    for (std::size_t i = 0; i < 6; i += 3)
        EXPECT_GT(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]).z, 0.0);
}

TEST_F(LoadGltf, leavesOutTrianglesWithARepeatedIndex) {
    Model model;
    Json primitive = positions(model.accessor(square, "VEC3"));
    primitive["indices"] = model.accessor<std::uint8_t>({0, 1, 2, 1, 1, 3, 3, 2, 3}, "SCALAR");
    model.root({{"mesh", model.mesh(primitive)}});
    EXPECT_THAT(load(model).meshes.at(0).indices, ElementsAre(0, 1, 2));
}

TEST_F(LoadGltf, leavesOutARestTooShortForATriangleWithAWarning) {
    Model model = indexedTriangle();
    model.json["meshes"][0]["primitives"][0]["indices"] = model.accessor<std::uint8_t>({0, 1, 2, 1}, "SCALAR");
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(data.warnings, ElementsAre("mesh 0 'gear', primitive 0: expected a multiple of 3 corners, found 4: the "
                                           "last are not drawn"));
}

TEST_F(LoadGltf, numbersTheMaterialOfEveryTriangle) {
    Model model;
    const int position = model.accessor(square, "VEC3");
    Json strip = positions(position);
    strip["mode"] = 5;
    Json plain = positions(model.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"));
    Json painted = plain;
    strip["material"] = 0;
    painted["material"] = 6;
    const Json primitives = {strip, plain, painted};
    model.root({{"mesh", model.add("meshes", {{"primitives", primitives}})}});
    EXPECT_THAT(load(model).meshes.at(0).materials, ElementsAre(1, 1, 0, 7));
}

TEST_F(LoadGltf, keepsNoMaterialsWhereThereAreNone) { EXPECT_THAT(load(triangle()).meshes.at(0).materials, IsEmpty()); }

TEST_F(LoadGltf, ignoresPointsAndLinesWithOneWarning) {
    Model model = indexedTriangle();
    const int position = model.accessor(square, "VEC3");
    for (const int mode : {0, 1, 2, 3, 3}) {
        Json primitive = positions(position);
        primitive["mode"] = mode;
        model.json["meshes"][0]["primitives"].push_back(primitive);
    }
    model.root({{"mesh", 0}});
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(data.warnings, ElementsAre("5 primitives of points or lines are not drawn: 1 LINES, 1 LINE_LOOP, 2 "
                                           "LINE_STRIP, 1 POINTS"));
}

TEST_F(LoadGltf, warnsOfPrimitivesWithoutPositions) {
    Model model = indexedTriangle();
    model.json["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
    EXPECT_THAT(load(model).warnings, ElementsAre("mesh 0 'gear', primitive 1: has no positions and is not drawn"));
}

TEST_F(LoadGltf, readsIndicesOfEveryWidth) {
    const std::vector<std::function<int(Model&)>> accessors{
        [](Model& model) {
            return model.accessor<std::uint8_t>({2, 0, 1}, "SCALAR");
        },
        [](Model& model) {
            return model.accessor<std::uint16_t>({2, 0, 1}, "SCALAR");
        },
        [](Model& model) {
            return model.accessor<std::uint32_t>({2, 0, 1}, "SCALAR");
        },
    };
    for (const auto& indices : accessors) {
        Model model = indexedTriangle();
        model.json["meshes"][0]["primitives"][0]["indices"] = indices(model);
        EXPECT_THAT(load(model).meshes.at(0).indices, ElementsAre(2, 0, 1));
    }
}

TEST_F(LoadGltf, readsInterleavedAttributes) {
    Model model;
    const int view = model.bufferView<float>({7, 7, 0, 0, 0, 0, 0, 1,  //
                                              7, 7, 1, 0, 0, 0, 1, 0,  //
                                              7, 7, 0, 1, 0, 1, 0, 0});
    model.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 32;
    const auto attribute = [&](int offset) {
        return model.add(
            "accessors",
            {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    };
    Json primitive = positions(attribute(8));
    primitive["attributes"]["NORMAL"] = attribute(20);
    model.root({{"mesh", model.mesh(primitive)}});
    const Scene::Data data = load(model);
    expectNear(worldCorners(data), triangleCorners);
    EXPECT_THAT(data.meshes.at(0).normals, ElementsAre(glm::vec3{0, 0, 1}, glm::vec3{0, 1, 0}, glm::vec3{1, 0, 0}));
}

TEST_F(LoadGltf, putsSparseValuesInPlace) {
    for (const bool overData : {true, false}) {
        Model model;
        const int places = model.bufferView<std::uint8_t>({1, 2});
        const int values = model.bufferView<float>({5, 0, 0, 0, 5, 0});
        Json accessor{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
        if (overData) accessor["bufferView"] = model.bufferView<float>({-1, 0, 0, 9, 9, 9, 9, 9, 9});
        accessor["sparse"] = {{"count", 2},
                              {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                              {"values", {{"bufferView", values}}}};
        model.root({{"mesh", model.mesh(positions(model.add("accessors", accessor)))}});
        expectNear(worldCorners(load(model)), {{overData ? -1 : 0, 0, 0}, {5, 0, 0}, {0, 5, 0}});
    }
}

TEST_F(LoadGltf, readsQuantizedPositionsAndNormals) {
    Model model;
    Json primitive = positions(model.accessor<std::int16_t>({0, 0, 0, 300, 0, 0, 0, -300, 0}, "VEC3"));
    primitive["attributes"]["NORMAL"] = model.accessor<std::int8_t>({0, 0, 127, 0, -128, 0, 100, 0, 0}, "VEC3");
    const auto normal = primitive["attributes"]["NORMAL"].get<std::size_t>();
    model.json["accessors"][normal]["normalized"] = true;
    model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    model.root({{"mesh", model.mesh(primitive)}});
    const Scene::Data data = load(model);
    expectNear(worldCorners(data), {{0, 0, 0}, {300, 0, 0}, {0, -300, 0}});
    EXPECT_THAT(data.meshes.at(0).normals, ElementsAre(glm::vec3{0, 0, 1}, glm::vec3{0, -1, 0}, glm::vec3{1, 0, 0}));
}

TEST_F(LoadGltf, scalesNormalizedPositionsToOne) {
    Model model;
    const int position = model.accessor<std::int8_t>({0, 0, 0, 127, 0, 0, -128, 64, 0}, "VEC3");
    model.json["accessors"][0]["normalized"] = true;
    model.root({{"mesh", model.mesh(positions(position))}});
    expectNear(worldCorners(load(model)), {{0, 0, 0}, {1, 0, 0}, {-1, 64.0 / 127.0, 0}});
}

TEST_F(LoadGltf, mergesThePrimitivesOfAMesh) {
    Model model = indexedTriangle();
    Json second = positions(model.accessor<float>({0, 0, 5, 1, 0, 5, 0, 1, 5}, "VEC3"));
    second["attributes"]["NORMAL"] = model.accessor<float>({0, 0, 2, 0, 0, 2, 0, 0, 2}, "VEC3");
    model.json["meshes"][0]["primitives"].push_back(second);
    const Scene::Data data = load(model);
    ASSERT_THAT(data.meshes, SizeIs(1));
    expectNear(worldCorners(data), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}});
    const glm::vec3 none{0.0F};
    const glm::vec3 up{0, 0, 1};
    EXPECT_THAT(data.meshes[0].normals, ElementsAre(none, none, none, up, up, up));
}

TEST_F(LoadGltf, leavesNormalsEmptyWhereNoPrimitiveHasThem) {
    EXPECT_THAT(load(triangle()).meshes.at(0).normals, IsEmpty());
}

TEST_F(LoadGltf, makesNormalsUnitAndUnusableOnesZero) {
    Model model = triangle();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    model.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        model.accessor<float>({0, 3, 4, 0, 0, 0, nan, 0, 1}, "VEC3");
    const std::vector<glm::vec3> normals = load(model).meshes.at(0).normals;
    EXPECT_THAT(normals, ElementsAre(glm::vec3{0, 0.6F, 0.8F}, glm::vec3{0}, glm::vec3{0}));
}

TEST_F(LoadGltf, centresMeshesFarFromTheOriginWithoutLoss) {
    Model model;
    const int position = model.accessor<float>({5e6F, 0, 0, 5e6F + 0.5F, 0, 0, 5e6F, 1.0F / 1024, 0}, "VEC3");
    model.root({{"mesh", model.mesh(positions(position))}});
    const Mesh mesh = load(model).meshes.at(0);
    EXPECT_EQ(mesh.origin, (glm::dvec3{5e6 + 0.25, 1.0 / 2048, 0}));
    EXPECT_EQ(mesh.positions.at(0), (glm::vec3{-0.25F, -1.0F / 2048, 0}));
    EXPECT_EQ(mesh.positions.at(1), (glm::vec3{0.25F, -1.0F / 2048, 0}));
}

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

// ---- what is refused: files

TEST_F(LoadGltf, saysWhatAFileIsThatIsNoModel) {
    EXPECT_EQ(refusal(folder_ / "missing.glb"), "expected a file, found none");
    EXPECT_EQ(refusal(folder_), "expected a file, found a folder");
    EXPECT_EQ(refusal("/dev/null"), "expected a regular file, found a device, pipe or socket");
    EXPECT_EQ(refusalOf(""), "expected a file with content, found an empty one");
    const std::string expected = "expected glTF 2.0 (.glb or .gltf), found ";
    EXPECT_EQ(refusalOf("\x89PNG\r\n\x1a\n"), expected + "a PNG picture");
    EXPECT_EQ(refusalOf("<!DOCTYPE html><html>"), expected + "HTML or XML");
    EXPECT_EQ(refusalOf("version https://git-lfs.github.com/spec/v1"),
              expected + "a Git LFS pointer instead of the file");
    EXPECT_EQ(refusalOf("# OBJ\nv 0 0 0\n"), expected + "other text");
    EXPECT_EQ(refusalOf(std::string("\x01\x00\x02", 3)), expected + "other data");
    EXPECT_THAT(refusalOf("{\"asset\":\n\n x}"), HasSubstr("expected JSON, found parse error at line 3, column 2"));
    EXPECT_EQ(refusalOf("{}"), "expected glTF 2.0, found JSON without asset.version");
    EXPECT_EQ(refusalOf(R"({"asset": {"version": "1.0"}})"), "expected glTF 2.0, found version '1.0'");
    EXPECT_EQ(refusalOf(R"({"asset": {"version": "2.0", "minVersion": "2.1"}})"),
              "expected glTF 2.0, found minVersion '2.1'");
}

TEST_F(LoadGltf, refusesAFifoWithoutWaitingForIt) {
    const fs::path fifo = folder_ / "pipe.glb";
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    EXPECT_THAT(refusal(fifo), HasSubstr("found a device, pipe or socket"));
}

TEST_F(LoadGltf, refusesUnreadableFiles) {
    const fs::path file = write("a.gltf", triangle().gltf());
    fs::permissions(file, fs::perms::none);
    if (std::ifstream{file}) GTEST_SKIP() << "this user reads files of any permissions";
    EXPECT_EQ(refusal(file), "expected a readable file, found one that does not open");
}

TEST_F(LoadGltf, refusesFilesOverTwoGibibytes) {
    const fs::path file = write("a.gltf", "{");
    fs::resize_file(file, std::uintmax_t{1} << 31);
    EXPECT_EQ(refusal(file),
              "expected at most 2147483647 more bytes in the files of a model, found 2147483648; raise max-file-size");
    Model model = triangle();
    static_cast<void>(write("b.bin", "b"));
    fs::resize_file(folder_ / "b.bin", (std::uintmax_t{1} << 31) - 100);
    model.json["buffers"] = {{{"byteLength", model.bytes.size()}, {"uri", "b.bin"}}};
    EXPECT_THAT(refusal(model), AllOf(HasSubstr("buffer 0: 'b.bin': expected at most "),
                                      HasSubstr("found 2147483548; raise max-file-size")));
}

TEST_F(LoadGltf, refusesATruncatedFileWhereverItIsCut) {
    for (const std::string& content : {indexedTriangle().glb(), indexedTriangle().gltf()})
        for (std::size_t size = 0; size < content.size(); ++size)
            EXPECT_NE(refusalOf(content.substr(0, size)), "") << "cut after " << size << " bytes";
    const std::string glb = indexedTriangle().glb();
    EXPECT_EQ(refusalOf(glb.substr(0, glb.size() - 1)),
              fmt::format("expected {} bytes as the header says, found {}: the file is truncated", glb.size(),
                          glb.size() - 1));
}

TEST_F(LoadGltf, survivesEveryChangedByte) {
    const std::string content = indexedTriangle().glb();
    for (std::size_t i = 0; i < content.size(); ++i) {
        for (const char byte : {'\0', '\xff', '9'}) {
            std::string changed = content;
            changed[i] = byte;
            try {
                for (const Mesh& mesh : loadGltf({write("model.glb", changed)}).meshes)
                    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
            } catch (const Error& error) {
                ASSERT_EQ(error.kind(), Error::Kind::Input);
            }
        }
    }
}

TEST_F(LoadGltf, readsBuffersOnlyFromTheModelsFolder) {
    Model model = triangle();
    const std::string content{model.bytes.begin(), model.bytes.end()};
    static_cast<void>(write("secret.bin", content));
    static_cast<void>(write("secret/b.bin", content));
    fs::create_directories(folder_ / "model");
    fs::create_symlink(folder_ / "secret.bin", folder_ / "model" / "link.bin");
    fs::create_directory_symlink(folder_ / "secret", folder_ / "model" / "links");
    fs::create_directories(folder_ / "model-2");
    static_cast<void>(write("model-2/b.bin", content));
    const std::string absolute = (folder_ / "secret.bin").string();
    for (const std::string& uri :
         {std::string{"../secret.bin"}, std::string{"%2e%2e/secret.bin"}, std::string{"..%2Fsecret.bin"},
          std::string{"a/../../secret.bin"}, std::string{"./../secret.bin"}, absolute, "file://" + absolute,
          std::string{"http://localhost/b.bin"}, std::string{"link.bin"}, std::string{"links/b.bin"},
          std::string{"../model-2/b.bin"}}) {
        model.json["buffers"] = {{{"byteLength", model.bytes.size()}, {"uri", uri}}};
        EXPECT_THAT(refusal(write("model/model.gltf", model.gltf())),
                    StartsWith("buffer 0: expected a file within the model's folder, found '"))
            << uri;
    }
}

TEST_F(LoadGltf, refusesBuffersThatAreMissingOrTooShort) {
    Model model = triangle();
    const auto refusalWith = [&](const Json& buffer) {
        model.json["buffers"] = {buffer};
        return refusal(model);
    };
    static_cast<void>(write("short.bin", "12345"));
    fs::create_directories(folder_ / "folder");
    ASSERT_EQ(mkfifo((folder_ / "fifo").c_str(), 0600), 0);
    EXPECT_EQ(refusalWith({{"byteLength", 36}, {"uri", "no.bin"}}),
              "buffer 0: expected the file 'no.bin', found: No such file or directory");
    EXPECT_EQ(refusalWith({{"byteLength", 36}, {"uri", "short.bin"}}), "buffer 0: expected 36 bytes, found 5");
    EXPECT_EQ(refusalWith({{"byteLength", 36}, {"uri", "folder"}}),
              "buffer 0: 'folder': expected a file, found a folder");
    EXPECT_THAT(refusalWith({{"byteLength", 36}, {"uri", "fifo"}}), HasSubstr("found a device, pipe or socket"));
    EXPECT_THAT(refusalWith({{"byteLength", 36}, {"uri", "a%0"}}), HasSubstr("expected two hexadecimal digits"));
    EXPECT_THAT(refusalWith({{"byteLength", 36}, {"uri", "a%00"}}), HasSubstr("found a zero byte"));
    EXPECT_THAT(refusalWith({{"byteLength", 36}}), HasSubstr("expected a uri or the binary chunk"));
    EXPECT_THAT(refusalWith({{"byteLength", 0}, {"uri", "short.bin"}}), HasSubstr("expected a byteLength over 0"));
    EXPECT_THAT(refusalWith({{"byteLength", -5}, {"uri", "short.bin"}}), HasSubstr("found -5"));
    EXPECT_THAT(refusalWith({{"byteLength", 4}, {"uri", 4}}), HasSubstr("expected a string as uri, found number"));
    EXPECT_THAT(refusalWith({{"byteLength", 4}, {"uri", "data:,abcd"}}), HasSubstr("expected a data URI in base64"));
    EXPECT_THAT(refusalWith({{"byteLength", 4}, {"uri", "data:;base64,AA$A"}}),
                HasSubstr("expected base64, found '$'"));
    EXPECT_THAT(refusalWith({{"byteLength", 4}, {"uri", "data:;base64,AAAA"}}), HasSubstr("expected 4 bytes, found 3"));
    EXPECT_THAT(refusalWith("buffer"), HasSubstr("buffer 0: expected an object, found string"));
}

TEST_F(LoadGltf, refusesJsonThatNestsTooDeep) {
    const std::string deep = R"({"asset": {"version": "2.0"}, "extras": )" + std::string(100'000, '[');
    EXPECT_EQ(refusalOf(deep), "expected JSON nested at most 500 deep, found deeper");
}

TEST_F(LoadGltf, keepsForeignTextOnOneLine) {
    Model model = indexedTriangle();
    model.json["nodes"][0]["name"] = "a\nb" + std::string(200, 'x');
    model.json["nodes"][0]["mesh"] = 9;
    EXPECT_THAT(refusal(model), StartsWith("node 0 'a?bxxx"));
    EXPECT_THAT(refusal(model), SizeIs(testing::Lt(200)));
}

// ---- what is refused: extensions

TEST_F(LoadGltf, namesEveryRequiredExtensionThatIsNotRead) {
    Model model = triangle();
    model.json["extensionsRequired"] = {"KHR_texture_transform", "ACME_hologram", "KHR_materials_unlit", "X_y"};
    EXPECT_EQ(refusal(model), "expected only required extensions that this version reads, found ACME_hologram, X_y");
    for (const char* compression : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
        if (gltf::readsCompression(compression)) continue;
        model.json["extensionsRequired"] = {compression};
        EXPECT_THAT(refusal(model),
                    HasSubstr(fmt::format("the geometry is compressed with {}, which this build does not read: {}: ",
                                          compression, compression)));
    }
}

TEST_F(LoadGltf, readsModelsWhoseRequiredExtensionsDoNotTouchGeometry) {
    Model model = triangle();
    model.json["extensionsRequired"] = {"KHR_materials_unlit",  "KHR_texture_transform", "KHR_texture_basisu",
                                        "EXT_texture_webp",     "KHR_lights_punctual",   "KHR_xmp_json_ld",
                                        "KHR_animation_pointer"};
    model.json["images"] = {{{"bufferView", 12345}, {"mimeType", "image/png"}}, {{"uri", "../missing.png"}}};
    expectNear(worldCorners(load(model)), triangleCorners);
}

TEST_F(LoadGltf, refusesDracoGeometryThatItDoesNotReadEvenIfItIsNotDeclaredAsRequired) {
    if (gltf::readsCompression("KHR_draco_mesh_compression")) GTEST_SKIP() << "this build reads it";
    Model model = indexedTriangle();
    model.json["accessors"][0].erase("bufferView");
    model.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
    EXPECT_THAT(refusal(model), HasSubstr("compressed with KHR_draco_mesh_compression"));
}

// ---- what is refused: contents. Each case breaks one thing in indexedTriangle().

struct Fault {
    std::string name;
    std::function<void(Model&)> breakIt;
    std::string message;
};

void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.name; }

std::vector<Fault> faults() {
    constexpr auto huge = std::numeric_limits<std::uint64_t>::max();
    const auto accessor = [](std::size_t i, const char* key, const Json& value) {
        return [=](Model& model) { model.json["accessors"][i][key] = value; };
    };
    const auto view = [](std::size_t i, const char* key, const Json& value) {
        return [=](Model& model) { model.json["bufferViews"][i][key] = value; };
    };
    const auto primitive = [](const char* key, const Json& value) {
        return [=](Model& model) { model.json["meshes"][0]["primitives"][0][key] = value; };
    };
    const auto node = [](const char* key, const Json& value) {
        return [=](Model& model) { model.json["nodes"][0][key] = value; };
    };
    const auto indices = [](const std::vector<std::uint16_t>& numbers) {
        return [=](Model& model) {
            model.json["meshes"][0]["primitives"][0]["indices"] = model.accessor(numbers, "SCALAR");
        };
    };
    const auto sparse = [](int count, std::uint8_t index, int offset) {
        return [=](Model& model) {
            const int places = model.bufferView<std::uint8_t>({index});
            const int values = model.bufferView<float>({0, 0, 0});
            model.json["accessors"][0]["sparse"] = {
                {"count", count},
                {"indices", {{"bufferView", places}, {"componentType", 5121}, {"byteOffset", offset}}},
                {"values", {{"bufferView", values}}}};
        };
    };
    const std::string positionsOf = "node 0 'wheel': mesh 0 'gear', primitive 0: POSITION: accessor 0: ";
    const std::string indicesOf = "node 0 'wheel': mesh 0 'gear', primitive 0: indices: accessor ";
    return {
        {"accessorBeyondItsView", accessor(0, "count", 4),
         positionsOf + "expected 4 elements of 12 bytes, 12 bytes apart, from byte 0, found a bufferView of 36 bytes"},
        {"accessorOffsetBeyondItsView", accessor(0, "byteOffset", 4), positionsOf + "expected 3 elements"},
        {"accessorOffsetThatOverflows", accessor(0, "byteOffset", huge), positionsOf + "expected 3 elements"},
        {"accessorCountThatOverflows", accessor(0, "count", huge),
         "primitive 0: expected at most 16777888 vertices and indices from so small a file, found more"},
        {"accessorCountBelowZero", accessor(0, "count", -1),
         "accessor 0: count: expected a number of at least 0, found -1"},
        {"zerosWithoutEnd",
         [](Model& model) {
             model.json["accessors"][0].erase("bufferView");
             model.json["accessors"][0]["count"] = 2'000'000'000;
         },
         "primitive 0: expected at most 16777888 vertices and indices from so small a file, found more"},
        {"viewBeyondItsBuffer", view(0, "byteLength", 1000),
         positionsOf + "bufferView 0: expected 1000 bytes from byte 0, found a buffer of 42 bytes"},
        {"viewOffsetThatOverflows", view(0, "byteOffset", huge), "found a buffer of 42 bytes"},
        {"viewLengthThatOverflows", view(1, "byteLength", huge), "found a buffer of 42 bytes"},
        {"strideBelowTheElement", view(0, "byteStride", 8),
         positionsOf + "expected a byteStride of at least 12, found 8"},
        {"strideBeyondTheView", view(0, "byteStride", 252), positionsOf + "expected 3 elements of 12 bytes, 252 bytes"},
        {"viewOfNoBuffer", view(0, "buffer", 3), positionsOf + "bufferView 0: expected a buffer below 1, found 3"},
        {"viewOfNegativeBuffer", view(0, "buffer", -3), "expected a buffer below 1, found -3"},
        {"accessorOfNoView", accessor(0, "bufferView", 7), positionsOf + "expected a bufferView below 2, found 7"},
        {"accessorOfNegativeView", accessor(0, "bufferView", -2), positionsOf + "expected a bufferView below 2"},
        {"positionsOfNoAccessor", primitive("attributes", {{"POSITION", 9}}), "expected an accessor below 2, found 9"},
        {"positionsOfAnAccessorBeyond32Bits", primitive("attributes", {{"POSITION", 4294967296}}),
         "expected an accessor below 2, found 2147483647"},
        {"positionsOfTwoComponents", accessor(0, "type", "VEC2"), positionsOf + "expected VEC3 of FLOAT or BYTE"},
        {"positionsOfLongIntegers", accessor(0, "componentType", 5125), "found VEC3 of UNSIGNED_INT"},
        {"positionsOfDoubles", accessor(0, "componentType", 5130), "expected componentType 5120, 5121"},
        {"indicesOfFloats", accessor(1, "componentType", 5126), indicesOf + "1: expected SCALAR of UNSIGNED_BYTE"},
        {"normalizedIndices", accessor(1, "normalized", true), "expected indices that are not normalized"},
        {"indicesOfNoAccessor", primitive("indices", 9), "accessor out of bounds"},
        {"indexBeyondTheVertices", indices({0, 1, 3}),
         indicesOf + "2: expected vertex indices below 3, found 3 at index 2"},
        {"primitiveRestart", indices({0, 65535, 2}),
         indicesOf + "2: expected vertex indices, found the primitive restart value 65535 at index 1"},
        {"modeThatIsNone", primitive("mode", 7), "primitive 0: expected a mode from 0 to 6, found 7"},
        {"attributesMissing", [](Model& model) { model.json["meshes"][0]["primitives"][0].erase("attributes"); },
         "expected glTF 2.0, found: "},
        {"normalsTooFew",
         [](Model& model) {
             const int normals = model.accessor<float>({0, 0, 1}, "VEC3");
             model.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
         },
         "NORMAL: expected as many elements as POSITION has, 3, found 1"},
        {"sparseIndexBeyondTheElements", sparse(1, 3, 0), positionsOf + "expected sparse indices below 3, found 3"},
        {"sparseIndicesBeyondTheirView", sparse(2, 0, 0), positionsOf + "expected 2 elements of 1 bytes"},
        {"sparseCountBelowZero", sparse(-1, 0, 0),
         "accessor 0: sparse: count: expected a number of at least 0, found -1"},
        {"sparseOffsetBelowZero", sparse(1, 0, -1),
         "accessor 0: sparse: indices: byteOffset: expected a number of at least 0, found -1"},
        {"positionThatIsNoNumber",
         [](Model& model) {
             const float nan = std::numeric_limits<float>::quiet_NaN();
             std::memcpy(model.bytes.data() + 16, &nan, sizeof nan);
         },
         "mesh 0 'gear', primitive 0: expected finite positions, found (1, nan, 0) at vertex 1"},
        {"positionThatIsInfinite",
         [](Model& model) {
             const float infinity = std::numeric_limits<float>::infinity();
             std::memcpy(model.bytes.data() + 24, &infinity, sizeof infinity);
         },
         "expected finite positions, found (inf, 1, 0) at vertex 2"},
        {"nodeOfNoMesh", node("mesh", 5), "node 0 'wheel': expected a mesh below 1, found 5"},
        {"nodeOfNoCamera", node("camera", 0), "node 0 'wheel': expected a camera below 0, found 0"},
        {"childThatIsNone", node("children", {5}), "node 0 'wheel': expected a child node below 1, found 5"},
        {"childThatIsItself", node("children", {0}),
         "node 0 'wheel': expected a tree of nodes, found a node among its own descendants"},
        {"cycleOfNodes",
         [](Model& model) {
             model.add("nodes", {{"children", {2}}});
             model.add("nodes", {{"children", {1}}, {"name", "loop"}});
         },
         "expected a tree of nodes, found a node among its own descendants"},
        {"nodeWithTwoParents",
         [](Model& model) {
             model.root({{"children", {3}}});
             model.root({{"children", {3}}});
             model.add("nodes", {{"name", "shared"}});
         },
         "node 3 'shared': expected one parent, found nodes 1 and 2"},
        {"nodeTwiceInTheScene",
         [](Model& model) {
             model.json["scenes"][0]["nodes"] = {0, 0};
         },
         "node 0 'wheel': expected it once in the scene, found it twice"},
        {"sceneOfNoNode", [](Model& model) { model.json["scenes"][0]["nodes"] = {3}; },
         "expected a node of the scene below 1, found 3"},
        {"defaultSceneThatIsNone", [](Model& model) { model.json["scene"] = 3; }, "expected a scene below 1, found 3"},
        {"matrixOfThreeNumbers", node("matrix", {1, 2, 3}), "node 0 'wheel': expected 16 numbers as matrix, found 3"},
        {"rotationOfThreeNumbers", node("rotation", {1, 2, 3}), "expected 4 numbers as rotation, found 3"},
        {"matrixWithAPerspective", node("matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
         "expected a matrix with last row 0 0 0 1, found 1 0 0 1"},
        {"transformThatOverflows",
         [](Model& model) {
             model.json["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
             model.json["nodes"][0]["children"] = {1};
             model.add("nodes", {{"scale", {1e200, 1e200, 1e200}}});
         },
         "node 1: expected a finite transform, found an infinite one"},
        {"instancesOfDifferentCounts",
         [](Model& model) {
             const int one = model.accessor<float>({0, 0, 1}, "VEC3");
             const int two = model.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC3");
             model.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", one},
                                                                                              {"SCALE", two}};
         },
         "EXT_mesh_gpu_instancing: SCALE: expected as many instances as before, 1, found 2"},
        {"instanceThatIsNoNumber",
         [](Model& model) {
             const int translation = model.accessor<float>({std::numeric_limits<float>::quiet_NaN(), 0, 1}, "VEC3");
             model.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                 {"TRANSLATION", translation}};
         },
         "node 0 'wheel': expected instances with finite transforms"},
    };
}

class LoadGltfFault : public LoadGltf, public testing::WithParamInterface<Fault> {};

TEST_P(LoadGltfFault, isRefusedByName) {
    Model model = indexedTriangle();
    ASSERT_THAT(load(model).instances, SizeIs(1));
    GetParam().breakIt(model);
    EXPECT_THAT(refusal(model), HasSubstr(GetParam().message));
    EXPECT_THAT(refusal(write("model.glb", model.glb())), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(, LoadGltfFault, testing::ValuesIn(faults()), [](const auto& one) { return one.param.name; });

// ---- real models

fs::path modelFolder() {
    if (const char* named = std::getenv("INKEDGE_MODELS")) return named;
    return fs::path{INKEDGE_SOURCE_DIR} / ".." / "shared" / "models";
}

std::uint64_t triangleCount(const Scene::Data& data) {
    std::uint64_t count = 0;
    for (const Instance& instance : data.instances) count += data.meshes.at(instance.mesh).indices.size() / 3;
    return count;
}

// The folder's MODELS.tsv: file, source, licence, triangles, what is special.
TEST(LoadGltfModels, haveTheTrianglesThatTheirTableSays) {
    std::ifstream table{modelFolder() / "MODELS.tsv"};
    if (!table)
        GTEST_SKIP() << "NO REAL MODEL IS TESTED: " << modelFolder() << " holds no MODELS.tsv; set INKEDGE_MODELS";
    int count = 0;
    for (std::string line; std::getline(table, line);) {
        std::istringstream stream{line};
        std::vector<std::string> fields;
        for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
        ASSERT_GE(fields.size(), 5U) << line;
        const std::string extension = fs::path{fields[0]}.extension().string();
        if (extension != ".glb" && extension != ".gltf") continue;
        ++count;
        try {
            LoadSettings settings;
            settings.alphaMask = AlphaMask::Ignore;  // a cut-out has more triangles than the file
            const Scene::Data data = loadGltf({modelFolder() / fields[0]}, settings);
            EXPECT_EQ(std::to_string(triangleCount(data)), fields[3]) << fields[0];
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("_compression, which this build does not read"));
            EXPECT_FALSE(gltf::readsCompression("KHR_draco_mesh_compression") &&
                         gltf::readsCompression("EXT_meshopt_compression"));
        }
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace inkedge

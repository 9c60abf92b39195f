#include "formats/gltf/load_gltf.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>

#include "formats/gltf/compression.h"
#include "formats/gltf/gltf_files.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using LoadGltf = GltfFileTest;

// ---- containers

TEST_F(LoadGltf, distinguishesGlbFromGltfByContent) {
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

TEST_F(LoadGltf, ignoresPointsWithOneWarning) {
    Model model = indexedTriangle();
    const int position = model.accessor(square, "VEC3");
    for (const int mode : {0, 0}) {
        Json primitive = positions(position);
        primitive["mode"] = mode;
        model.json["meshes"][0]["primitives"].push_back(primitive);
    }
    model.root({{"mesh", 0}});
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(data.warnings, ElementsAre("2 primitives of points are not drawn"));
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

TEST_F(LoadGltf, putsSparseValuesWhereTheyBelong) {
    for (const bool overData : {true, false}) {
        Model model;
        const int indices = model.bufferView<std::uint8_t>({1, 2});
        const int values = model.bufferView<float>({5, 0, 0, 0, 5, 0});
        Json accessor{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
        if (overData) accessor["bufferView"] = model.bufferView<float>({-1, 0, 0, 9, 9, 9, 9, 9, 9});
        accessor["sparse"] = {{"count", 2},
                              {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
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
            EXPECT_FALSE(readsCompression("KHR_draco_mesh_compression") && readsCompression("EXT_meshopt_compression"));
        }
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace inkedge::gltf

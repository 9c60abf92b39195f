#include "formats/gltf/load_gltf.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <draco/attributes/geometry_attribute.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "formats/gltf/compressed_models.h"
#include "formats/gltf/draco.h"

namespace inkedge::gltf {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Json = nlohmann::json;
using namespace compressed_models;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

// ---- KHR_draco_mesh_compression

struct DracoChoice {
    int method = draco::MESH_EDGEBREAKER_ENCODING;
    int bits = 14;  // 0: not quantized
};

Bytes encodeDraco(const Grid& grid, const DracoChoice& choice) {
    draco::Mesh mesh;
    mesh.set_num_points(static_cast<std::uint32_t>(grid.vertexCount()));
    draco::GeometryAttribute description;
    description.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int position = mesh.AddAttribute(description, true, static_cast<std::uint32_t>(grid.vertexCount()));
    for (std::uint32_t i = 0; i < grid.vertexCount(); ++i)
        mesh.attribute(position)->SetAttributeValue(draco::AttributeValueIndex{i}, &grid.positions[i * 3]);
    mesh.attribute(position)->set_unique_id(7);
    for (std::size_t i = 0; i < grid.indices.size(); i += 3)
        mesh.AddFace({draco::PointIndex{grid.indices[i]}, draco::PointIndex{grid.indices[i + 1]},
                      draco::PointIndex{grid.indices[i + 2]}});
    draco::Encoder encoder;
    encoder.SetEncodingMethod(choice.method);
    if (choice.bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, choice.bits);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
    return {buffer.data(), buffer.data() + buffer.size()};
}

Model dracoModel(const Grid& grid, const DracoChoice& choice = {}) {
    Model model;
    model.json["extensionsRequired"] = {draco};
    const std::size_t view = model.add("bufferViews", model.slice(encodeDraco(grid, choice)));
    const auto bare = [&](int component, std::size_t count, const char* type) {
        return model.add("accessors", {{"componentType", component}, {"count", count}, {"type", type}});
    };
    const std::size_t position = bare(5126, grid.vertexCount(), "VEC3");
    const std::size_t indices = bare(5123, grid.indices.size(), "SCALAR");
    const Json extension{{"bufferView", view}, {"attributes", {{"POSITION", 7}}}};
    const Json primitive{{"attributes", {{"POSITION", position}}},
                         {"indices", indices},
                         {"material", 3},
                         {"extensions", {{draco, extension}}}};
    model.add("meshes", {{"name", "gear"}, {"primitives", {primitive}}});
    return model;
}

TEST(LoadDraco, readsEveryMethod) {
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING})
        for (const std::uint32_t side : {2U, 5U, 40U})
            EXPECT_EQ(trianglesOf(loaded(dracoModel(Grid{side}, {method, 0}))), trianglesOf(Grid{side})) << method;
}

TEST(LoadDraco, readsQuantizedPositionsWithinTheirStep) {
    const Scene::Data data = loaded(dracoModel(Grid{40}, {draco::MESH_EDGEBREAKER_ENCODING, 16}));
    const Mesh& mesh = data.meshes.at(0);
    EXPECT_THAT(mesh.indices, SizeIs(Grid{40}.indices.size()));
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 world = mesh.origin + glm::dvec3{p};
        EXPECT_NEAR(world.z, world.x * world.y, 2.0);
        EXPECT_NEAR(world.x, std::round(world.x), 0.05);
    }
}

TEST(LoadDraco, keepsWhatElseThePrimitiveSays) {
    EXPECT_THAT(loaded(dracoModel(Grid{2})).meshes.at(0).materials, ElementsAre(4, 4));
}

TEST(LoadDraco, readsPrimitivesThatShareTheirData) {
    Model model = dracoModel(Grid{5});
    Json& primitives = model.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["material"] = 0;
    const Scene::Data data = loaded(model);
    EXPECT_THAT(data.meshes.at(0).indices, SizeIs(2 * Grid{5}.indices.size()));
    EXPECT_EQ(data.meshes[0].materials.front(), 4U);
    EXPECT_EQ(data.meshes[0].materials.back(), 1U);
}

TEST(LoadDraco, prefersCompressedDataToPlainData) {
    Model model = dracoModel(Grid{5}, {draco::MESH_SEQUENTIAL_ENCODING, 0});
    model.json.erase("extensionsRequired");
    const std::vector<float> zeros(75);
    model.json["accessors"][0]["bufferView"] = model.add("bufferViews", model.slice(bytesOfAll(zeros)));
    EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(Grid{5}));
}

TEST(LoadDraco, readsDataUnderBothCompressions) {
    Model model = dracoModel(Grid{5}, {draco::MESH_SEQUENTIAL_ENCODING, 0});
    Bytes data = model.bytes;
    data.resize((data.size() + 3) / 4 * 4);
    model.json["buffers"] = {{{"byteLength", 1}, {"extensions", {{meshopt, {{"fallback", true}}}}}}};
    const std::size_t view =
        compressedView(model, encodeVertices(data.data(), data.size() / 4, 4), "ATTRIBUTES", data.size() / 4, 4);
    model.json["meshes"][0]["primitives"][0]["extensions"][draco]["bufferView"] = view;
    EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(Grid{5}));
}

Json& primitiveOf(Model& model) { return model.json["meshes"][0]["primitives"][0]; }
Json& extensionOf(Model& model) { return primitiveOf(model)["extensions"][draco]; }

TEST(LoadDraco, refusesWhatDoesNotAgreeWithTheAccessors) {
    expectRefused(
        [] { return dracoModel(Grid{5}); },
        {
            {"no view", [](Model& m) { extensionOf(m).erase("bufferView"); }, "as bufferView, found null"},
            {"missing view", [](Model& m) { extensionOf(m)["bufferView"] = 9; },
             "expected an index of bufferViews below 1, found 9"},
            {"no attributes", [](Model& m) { extensionOf(m)["attributes"] = 3; }, "expected attributes, found 3"},
            {"id of no number", [](Model& m) { extensionOf(m)["attributes"]["POSITION"] = "7"; },
             "POSITION: expected the id of an attribute, found \"7\""},
            {"missing id", [](Model& m) { extensionOf(m)["attributes"]["POSITION"] = 8; },
             "mesh 0 'gear', primitive 0: KHR_draco_mesh_compression: attribute 8: expected an attribute of that id"},
            {"attribute without an accessor", [](Model& m) { extensionOf(m)["attributes"]["NORMAL"] = 7; },
             "NORMAL: expected a number of at least 0 as NORMAL, found null"},
            {"more triangles", [](Model& m) { m.json["accessors"][1]["count"] = 99; },
             "expected 33 triangles as the accessor of the indices says, found 32"},
            {"more vertices", [](Model& m) { m.json["accessors"][0]["count"] = 26; },
             "POSITION: expected 26 vertices as the accessor says, found 25"},
            {"component type", [](Model& m) { m.json["accessors"][0]["componentType"] = 5123; },
             "expected VEC3 of componentType 5123 as the accessor says, found 3 components of 5126"},
            {"type", [](Model& m) { m.json["accessors"][0]["type"] = "VEC2"; }, "expected VEC2 of componentType 5126"},
            {"fan", [](Model& m) { primitiveOf(m)["mode"] = 6; },
             "expected mode TRIANGLES or TRIANGLE_STRIP, found TRIANGLE_FAN"},
            {"no Draco", [](Model& m) { m.bytes[0] = 'X'; }, "expected Draco data, found: Not a Draco file."},
            {"other bitstream", [](Model& m) { m.bytes[6] = 9; }, "expected Draco bitstream 2.2, found 2.9"},
            {"point cloud", [](Model& m) { m.bytes[7] = 0; }, "expected a Draco mesh, found geometry of type 0"},
            {"header alone", [](Model& m) { m.json["bufferViews"][0]["byteLength"] = 11; }, "they are truncated"},
            {"truncated", [](Model& m) { m.json["bufferViews"][0]["byteLength"] = 60; }, "expected Draco data, found"},
        });
}

TEST(LoadDraco, refusesMoreTrianglesThanItHasMemoryFor) {
    Bytes data = encodeDraco(Grid{2}, {draco::MESH_SEQUENTIAL_ENCODING, 0});
    const Bytes huge{0xff, 0xff, 0xff, 0xff, 0x04};  // the number of triangles, 7 bits a byte
    data.erase(data.begin() + 11);
    data.insert(data.begin() + 11, huge.begin(), huge.end());
    expectError(Error::Kind::Input, HasSubstr("expected at most 16777216 triangles in a Draco mesh, found 1342177279"),
                [&] {
                    static_cast<void>(decodeDraco(data, {{7}, {}}, 1 << 30));
                });
    expectError(Error::Kind::Input, HasSubstr("expected at most 100 bytes more"), [&] {
        static_cast<void>(decodeDraco(encodeDraco(Grid{5}, {}), {{7}, {}}, 100));
    });
}

// ---- both

TEST(LoadCompressed, survivesEveryChangedByte) {
    for (const Model& sound :
         {meshoptModel(Grid{3}), dracoModel(Grid{3}), dracoModel(Grid{3}, {draco::MESH_SEQUENTIAL_ENCODING, 10})}) {
        for (std::size_t i = 0; i < sound.bytes.size(); ++i) {
            for (const int change : {0x01, 0x80, 0xff}) {
                Model model = sound;
                model.bytes[i] = static_cast<std::uint8_t>(model.bytes[i] ^ change);
                try {
                    static_cast<void>(loaded(model));
                } catch (const Error& error) {
                    EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::gltf

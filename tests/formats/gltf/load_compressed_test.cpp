#include "formats/gltf/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <draco/attributes/geometry_attribute.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "formats/gltf/draco.h"
#include "formats/gltf/encode_exponential.h"
#include "formats/gltf/meshopt.h"

namespace inkedge {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* draco = "KHR_draco_mesh_compression";
constexpr const char* meshopt = "EXT_meshopt_compression";

template <class T>
Bytes bytesOfAll(const std::vector<T>& values) {
    Bytes bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

// A bent grid of side * side vertices.
struct Grid {
    explicit Grid(std::uint32_t side) {
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x)
                positions.insert(positions.end(),
                                 {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y)});
        for (std::uint32_t y = 0; y + 1 < side; ++y)
            for (std::uint32_t x = 0; x + 1 < side; ++x) {
                const std::uint32_t a = y * side + x;
                indices.insert(indices.end(), {a, a + 1, a + side, a + side, a + 1, a + side + 1});
            }
    }
    [[nodiscard]] std::size_t vertexCount() const { return positions.size() / 3; }
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};

// ---- a binary glTF whose buffer 0 holds the compressed data

struct Model {
    Json json = {{"asset", {{"version", "2.0"}}}, {"nodes", {{{"mesh", 0}}}}};
    Bytes bytes;

    Json place(const Bytes& data) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        const std::size_t offset = bytes.size();
        bytes.insert(bytes.end(), data.begin(), data.end());
        return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", data.size()}};
    }

    std::size_t add(const char* list, const Json& item) {
        json[list].push_back(item);
        return json[list].size() - 1;
    }

    [[nodiscard]] std::string glb() const {
        Json whole = json;
        Json buffers = {{{"byteLength", bytes.size()}}};
        if (whole.contains("buffers")) buffers.insert(buffers.end(), whole["buffers"].begin(), whole["buffers"].end());
        whole["buffers"] = buffers;
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string binary{bytes.begin(), bytes.end()};
        binary.resize((binary.size() + 3) / 4 * 4);
        return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
               word(binary.size()) + std::string{"BIN\0", 4} + binary;
    }

private:
    static std::string word(std::size_t number) {
        std::string text;
        for (int i = 0; i < 4; ++i) text += static_cast<char>(number >> (8 * i) & 255);
        return text;
    }
};

Scene::Data load(const Model& model) {
    const TemporaryFolder folder;
    put(folder / "a.glb", model.glb());
    return loadGltf({folder / "a.glb"});
}

std::string refusal(const Model& model) {
    try {
        static_cast<void>(load(model));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
        return error.what();
    }
    ADD_FAILURE() << "accepted";
    return {};
}

// The corners of every triangle, each triangle turned to start at its least corner, sorted: order does not count.
std::vector<std::vector<double>> trianglesOf(const std::vector<glm::dvec3>& positions,
                                             const std::vector<std::uint32_t>& indices) {
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::vector<std::vector<double>> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = positions.at(indices[i + k]);
            corners.push_back({p.x, p.y, p.z});
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        all.emplace_back();
        for (const auto& corner : corners) all.back().insert(all.back().end(), corner.begin(), corner.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::vector<double>> trianglesOf(const Grid& grid) {
    std::vector<glm::dvec3> positions;
    for (std::size_t i = 0; i < grid.positions.size(); i += 3)
        positions.emplace_back(grid.positions[i], grid.positions[i + 1], grid.positions[i + 2]);
    return trianglesOf(positions, grid.indices);
}

std::vector<std::vector<double>> trianglesOf(const Scene::Data& data) {
    const Mesh& mesh = data.meshes.at(0);
    std::vector<glm::dvec3> positions;
    for (const glm::vec3& p : mesh.positions) positions.push_back(mesh.origin + glm::dvec3{p});
    return trianglesOf(positions, mesh.indices);
}

// ---- EXT_meshopt_compression

Bytes encodeVertices(const void* data, std::size_t count, std::size_t stride) {
    Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), data, count, stride));
    return bytes;
}

Bytes encodeTriangles(const Grid& grid) {
    Bytes bytes(meshopt_encodeIndexBufferBound(grid.indices.size(), grid.vertexCount()));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), grid.indices.data(), grid.indices.size()));
    return bytes;
}

Bytes encodeIndices(const Grid& grid) {
    Bytes bytes(meshopt_encodeIndexSequenceBound(grid.indices.size(), grid.vertexCount()));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), grid.indices.data(), grid.indices.size()));
    return bytes;
}

// A bufferView of buffer 1, which has no data.
std::size_t compressedView(Model& model, const Bytes& data, const std::string& mode, std::size_t count,
                           std::size_t stride, const std::string& filter = {}) {
    Json extension = model.place(data);
    extension.update({{"mode", mode}, {"count", count}, {"byteStride", stride}});
    if (!filter.empty()) extension["filter"] = filter;
    return model.add("bufferViews",
                     {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{meshopt, extension}}}});
}

std::size_t accessor(Model& model, std::size_t view, int component, std::size_t count, const std::string& type) {
    return model.add("accessors",
                     {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
}

Model meshoptModel(const Grid& grid, const std::string& mode = "TRIANGLES", std::size_t indexSize = 4) {
    Model model;
    model.json["extensionsRequired"] = {meshopt};
    model.json["buffers"] = {{{"byteLength", 1 << 20}, {"extensions", {{meshopt, {{"fallback", true}}}}}}};
    const std::size_t vertices = compressedView(model, encodeVertices(grid.positions.data(), grid.vertexCount(), 12),
                                                "ATTRIBUTES", grid.vertexCount(), 12);
    const std::size_t indices = compressedView(model, mode == "TRIANGLES" ? encodeTriangles(grid) : encodeIndices(grid),
                                               mode, grid.indices.size(), indexSize);
    const Json primitive{
        {"attributes", {{"POSITION", accessor(model, vertices, 5126, grid.vertexCount(), "VEC3")}}},
        {"indices", accessor(model, indices, indexSize == 4 ? 5125 : 5123, grid.indices.size(), "SCALAR")}};
    model.add("meshes", {{"primitives", {primitive}}});
    return model;
}

TEST(LoadMeshopt, readsEveryModeAndIndexWidth) {
    for (const char* mode : {"TRIANGLES", "INDICES"})
        for (const std::size_t indexSize : {2U, 4U})
            for (const std::uint32_t side : {2U, 5U, 40U})
                EXPECT_EQ(trianglesOf(load(meshoptModel(Grid{side}, mode, indexSize))), trianglesOf(Grid{side}))
                    << mode;
}

TEST(LoadMeshopt, readsEveryFilter) {
    const std::vector<float> normals{0, 0, 1, 0, 0.6F, 0, 0.8F, 0, 0, -1, 0, 0, 0, 0.6F, -0.8F, 0, -1, 0, 0, 0};
    Bytes octahedral(5 * 8);
    meshopt_encodeFilterOct(octahedral.data(), 5, 8, 16, normals.data());
    const Bytes asNormals =
        gltf::decodeMeshopt({5, 8, "ATTRIBUTES", "OCTAHEDRAL"}, encodeVertices(octahedral.data(), 5, 8), 1 << 20);
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            std::int16_t value = 0;
            std::memcpy(&value, asNormals.data() + i * 8 + k * 2, 2);
            EXPECT_NEAR(value / 32767.0, normals[i * 4 + k], 1e-3);
        }

    const std::vector<float> numbers{1.5F, -2, 1e-3F, 1e6F, 0, 7};
    Bytes exponential(6 * 4);
    encodeExponential(exponential.data(), 6, 4, 23, numbers.data());
    const Bytes asNumbers =
        gltf::decodeMeshopt({6, 4, "ATTRIBUTES", "EXPONENTIAL"}, encodeVertices(exponential.data(), 6, 4), 1 << 20);
    for (std::size_t i = 0; i < 6; ++i) {
        float value = 0;
        std::memcpy(&value, asNumbers.data() + i * 4, 4);
        EXPECT_NEAR(value, numbers[i], 1e-5 * std::abs(numbers[i]));
    }

    const std::vector<float> rotations{0, 0, 0, 1, 0.6F, 0, 0, 0.8F};
    Bytes quaternions(2 * 8);
    meshopt_encodeFilterQuat(quaternions.data(), 2, 8, 16, rotations.data());
    const Bytes asRotations =
        gltf::decodeMeshopt({2, 8, "ATTRIBUTES", "QUATERNION"}, encodeVertices(quaternions.data(), 2, 8), 1 << 20);
    std::int16_t last = 0;
    std::memcpy(&last, asRotations.data() + 14, 2);
    EXPECT_NEAR(std::abs(last) / 32767.0, 0.8, 1e-3);
}

TEST(LoadMeshopt, readsCompressedDataEvenWhereTheFallbackHasAUriThatLeadsNowhere) {
    Model model = meshoptModel(Grid{5});
    model.json["buffers"][0]["uri"] = "missing.bin";
    EXPECT_EQ(trianglesOf(load(model)), trianglesOf(Grid{5}));
}

struct Fault {
    std::string name;
    std::function<void(Model&)> breakIt;
    std::string expected;
};

void expectRefused(const std::function<Model()>& sound, const std::vector<Fault>& faults) {
    ASSERT_NO_THROW(static_cast<void>(load(sound())));
    for (const Fault& fault : faults) {
        Model model = sound();
        fault.breakIt(model);
        EXPECT_THAT(refusal(model), HasSubstr(fault.expected)) << fault.name;
    }
}

std::function<void(Model&)> setInView(std::size_t view, const std::string& key, const Json& value) {
    return [=](Model& model) { model.json["bufferViews"][view]["extensions"][meshopt][key] = value; };
}

TEST(LoadMeshopt, refusesWhatTheExtensionDoesNotAllow) {
    expectRefused(
        [] { return meshoptModel(Grid{5}); },
        {
            {"mode", setInView(0, "mode", "NEW"), "expected mode ATTRIBUTES, TRIANGLES or INDICES, found 'NEW'"},
            {"no mode", setInView(0, "mode", nullptr), "found ''"},
            {"mode of no string", setInView(0, "mode", 1), "expected a string as mode, found 1"},
            {"filter", setInView(0, "filter", "NEW"), "found 'NEW'"},
            {"filter of indices", setInView(1, "filter", "EXPONENTIAL"), "expected filter NONE in TRIANGLES"},
            {"filter of another stride", setInView(0, "filter", "OCTAHEDRAL"),
             "that filter OCTAHEDRAL takes, found 12"},
            {"stride", setInView(0, "byteStride", 13),
             "expected a byteStride of 4, 8, ... 256 in ATTRIBUTES, found 13"},
            {"no stride", setInView(0, "byteStride", 0), "found 0"},
            {"large stride", setInView(0, "byteStride", 260), "found 260"},
            {"index stride", setInView(1, "byteStride", 1), "expected a byteStride of 2 or 4 in TRIANGLES, found 1"},
            {"negative stride", setInView(0, "byteStride", -4),
             "expected a number of at least 0 as byteStride, found -4"},
            {"count", setInView(0, "count", 0), "expected a count of at least 1, found 0"},
            {"count of triangles", setInView(1, "count", 97), "expected a count that is a multiple of 3"},
            {"more elements", setInView(0, "count", 26), "expected a byteLength of 312"},
            {"elements without data", setInView(0, "count", 20'000'000), "expected compressed data of at least"},
            {"too many elements", setInView(0, "count", 200'000'000), "expected at most 1073741824 bytes more"},
            {"too little data", setInView(0, "byteLength", 40), "found data that do not decode"},
            {"missing data", setInView(0, "byteLength", 99999), "expected 99999 bytes from byte 0"},
            {"missing buffer", setInView(0, "buffer", 7), "expected an index of buffers below 2, found 7"},
            {"fallback as data", setInView(0, "buffer", 1), "expected data, found a buffer that stands in for some"},
            {"other length", [](Model& m) { m.json["bufferViews"][0]["byteLength"] = 299; },
             "bufferView 0: expected a byteLength of 300 as EXT_meshopt_compression gives, found 299"},
            {"view of the fallback", [](Model& m) { m.json["bufferViews"][0].erase("extensions"); },
             "bufferView 0: expected data of its own"},
            {"more than the view", [](Model& m) { m.json["accessors"][0]["count"] = 26; },
             "expected 26 elements of 12"},
            {"garbage", [](Model& m) { std::fill_n(m.bytes.begin(), 40, std::uint8_t{0x55}); }, "do not decode"},
        });
}

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
    const std::size_t view = model.add("bufferViews", model.place(encodeDraco(grid, choice)));
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
            EXPECT_EQ(trianglesOf(load(dracoModel(Grid{side}, {method, 0}))), trianglesOf(Grid{side})) << method;
}

TEST(LoadDraco, readsQuantizedPositionsWithinTheirStep) {
    const Scene::Data data = load(dracoModel(Grid{40}, {draco::MESH_EDGEBREAKER_ENCODING, 16}));
    const Mesh& mesh = data.meshes.at(0);
    EXPECT_THAT(mesh.indices, SizeIs(Grid{40}.indices.size()));
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 world = mesh.origin + glm::dvec3{p};
        EXPECT_NEAR(world.z, world.x * world.y, 2.0);
        EXPECT_NEAR(world.x, std::round(world.x), 0.05);
    }
}

TEST(LoadDraco, keepsWhatElseThePrimitiveSays) {
    EXPECT_THAT(load(dracoModel(Grid{2})).meshes.at(0).materials, ElementsAre(4, 4));
}

TEST(LoadDraco, readsPrimitivesThatShareTheirData) {
    Model model = dracoModel(Grid{5});
    Json& primitives = model.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["material"] = 0;
    const Scene::Data data = load(model);
    EXPECT_THAT(data.meshes.at(0).indices, SizeIs(2 * Grid{5}.indices.size()));
    EXPECT_EQ(data.meshes[0].materials.front(), 4U);
    EXPECT_EQ(data.meshes[0].materials.back(), 1U);
}

TEST(LoadDraco, prefersCompressedDataToPlainData) {
    Model model = dracoModel(Grid{5}, {draco::MESH_SEQUENTIAL_ENCODING, 0});
    model.json.erase("extensionsRequired");
    const std::vector<float> zeros(75);
    model.json["accessors"][0]["bufferView"] = model.add("bufferViews", model.place(bytesOfAll(zeros)));
    EXPECT_EQ(trianglesOf(load(model)), trianglesOf(Grid{5}));
}

TEST(LoadDraco, readsDataUnderBothCompressions) {
    Model model = dracoModel(Grid{5}, {draco::MESH_SEQUENTIAL_ENCODING, 0});
    Bytes data = model.bytes;
    data.resize((data.size() + 3) / 4 * 4);
    model.json["buffers"] = {{{"byteLength", 1}, {"extensions", {{meshopt, {{"fallback", true}}}}}}};
    const std::size_t view =
        compressedView(model, encodeVertices(data.data(), data.size() / 4, 4), "ATTRIBUTES", data.size() / 4, 4);
    model.json["meshes"][0]["primitives"][0]["extensions"][draco]["bufferView"] = view;
    EXPECT_EQ(trianglesOf(load(model)), trianglesOf(Grid{5}));
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
                    static_cast<void>(gltf::decodeDraco(data, {{7}, {}}, 1 << 30));
                });
    expectError(Error::Kind::Input, HasSubstr("expected at most 100 bytes more"), [&] {
        static_cast<void>(gltf::decodeDraco(encodeDraco(Grid{5}, {}), {{7}, {}}, 100));
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
                    static_cast<void>(load(model));
                } catch (const Error& error) {
                    EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge

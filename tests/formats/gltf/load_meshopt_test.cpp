#include "formats/gltf/load_gltf.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <gmock/gmock.h>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "formats/gltf/compressed_models.h"
#include "formats/gltf/encode_exponential.h"
#include "formats/gltf/encode_vertices.h"
#include "formats/gltf/meshopt.h"

namespace inkedge::gltf {
namespace {

using Bytes = std::vector<std::uint8_t>;
using namespace compressed_models;

TEST(LoadMeshopt, readsEveryModeAndIndexWidth) {
    for (const char* mode : {"TRIANGLES", "INDICES"})
        for (const std::size_t indexSize : {2U, 4U})
            for (const std::uint32_t side : {2U, 5U, 40U})
                EXPECT_EQ(trianglesOf(loaded(meshoptModel(Grid{side}, mode, indexSize))), trianglesOf(Grid{side}))
                    << mode;
}

TEST(LoadMeshopt, readsEveryFilter) {
    const std::vector<float> normals{0, 0, 1, 0, 0.6F, 0, 0.8F, 0, 0, -1, 0, 0, 0, 0.6F, -0.8F, 0, -1, 0, 0, 0};
    Bytes octahedral(5 * 8);
    meshopt_encodeFilterOct(octahedral.data(), 5, 8, 16, normals.data());
    const Bytes asNormals =
        decodeMeshopt({5, 8, "ATTRIBUTES", "OCTAHEDRAL"}, encodeVertices(octahedral.data(), 5, 8), 1 << 20);
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
        decodeMeshopt({6, 4, "ATTRIBUTES", "EXPONENTIAL"}, encodeVertices(exponential.data(), 6, 4), 1 << 20);
    for (std::size_t i = 0; i < 6; ++i) {
        float value = 0;
        std::memcpy(&value, asNumbers.data() + i * 4, 4);
        EXPECT_NEAR(value, numbers[i], 1e-5 * std::abs(numbers[i]));
    }

    const std::vector<float> rotations{0, 0, 0, 1, 0.6F, 0, 0, 0.8F};
    Bytes quaternions(2 * 8);
    meshopt_encodeFilterQuat(quaternions.data(), 2, 8, 16, rotations.data());
    const Bytes asRotations =
        decodeMeshopt({2, 8, "ATTRIBUTES", "QUATERNION"}, encodeVertices(quaternions.data(), 2, 8), 1 << 20);
    std::int16_t last = 0;
    std::memcpy(&last, asRotations.data() + 14, 2);
    EXPECT_NEAR(std::abs(last) / 32767.0, 0.8, 1e-3);
}

// Compresses the grid's positions anew, as elements of so many bytes.
void putVertices(Model& model, const Grid& grid, std::size_t stride, bool version1) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(grid.positions.data());
    const std::size_t count = grid.vertexCount() * 12 / stride;
    Json& view = model.json["bufferViews"][0];
    view["extensions"][meshopt].update(
        model.slice(version1 ? vertex_codec::encode(bytes, count, stride, Bytes(stride / 4, 2))
                             : encodeVertices(bytes, count, stride)));
    view["extensions"][meshopt].update({{"byteStride", stride}, {"count", count}});
}

TEST(LoadMeshopt, readsBothExtensionsInBothVersions) {
    for (const bool version1 : {false, true})
        for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
            for (const std::uint32_t side : {2U, 5U, 40U}) {
                Model model = meshoptModel(Grid{side});
                putVertices(model, Grid{side}, 12, version1);
                const Scene::Data data = loaded(renamed(model, extension));
                EXPECT_EQ(trianglesOf(data), trianglesOf(Grid{side})) << extension << version1;
                EXPECT_THAT(data.warnings, testing::IsEmpty());
            }
}

TEST(LoadMeshopt, readsViewsWhoseStrideIsNotThatOfTheirCompressedElements) {
    const Grid grid{6};
    for (const std::size_t stride : {4U, 12U, 36U, 72U})
        for (const bool version1 : {false, true}) {
            Model model = meshoptModel(grid);
            model.json["bufferViews"][0]["byteStride"] = 12;
            putVertices(model, grid, stride, version1);
            EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(grid)) << stride;
        }
}

TEST(LoadMeshopt, readsBuffersWithoutDataThatNothingMarks) {
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        Model model = renamed(meshoptModel(Grid{5}), extension);
        model.json["buffers"][0].erase("extensions");
        EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(Grid{5}));
    }
}

TEST(LoadMeshopt, readsColors) {
    const auto decoded = [](const auto& plain, std::size_t stride) {
        const Bytes bytes = bytesOfAll(plain);
        const Bytes data = encodeVertices(bytes.data(), bytes.size() / stride, stride);
        return decodeMeshopt({bytes.size() / stride, stride, "ATTRIBUTES", "COLOR"}, data, 1 << 20);
    };
    // luma 100, differences 20 and -30 in 8 bits; 10, 3 and -2 in 5 bits; nothing
    const std::vector<std::uint8_t> in8Bits{100, 20, 226, 0x80 | 127, 100, 20, 226, 0x80 | 64,
                                            10,  3,  254, 0x10 | 15,  5,   5,  5,   0};
    EXPECT_THAT(decoded(in8Bits, 4),
                testing::ElementsAre(150, 70, 110, 255, 150, 70, 110, 128, 123, 66, 74, 255, 0, 0, 0, 0));
    const std::vector<std::uint16_t> in16Bits{30000, 1000, 65536 - 2000, 0x8000 | 0x7fff, 400, 100, 0, 0x200 | 0x1ff};
    EXPECT_EQ(decoded(in16Bits, 8),
              bytesOfAll(std::vector<std::uint16_t>{33000, 28000, 31000, 65535, 32031, 25625, 19218, 65535}));
}

TEST(LoadMeshopt, readsElementsThatAreAllTheSame) {
    const Bytes plain(4 * 300'000, 9);
    for (const Bytes& data :
         {vertex_codec::encode(plain.data(), 300'000, 4, {0}), encodeVertices(plain.data(), 300'000, 4)})
        EXPECT_EQ(decodeMeshopt({300'000, 4, "ATTRIBUTES", "NONE"}, data, 1 << 24), plain);
}

TEST(LoadMeshopt, readsCompressedDataEvenWhereTheFallbackHasAUriThatLeadsNowhere) {
    Model model = meshoptModel(Grid{5});
    model.json["buffers"][0]["uri"] = "missing.bin";
    EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(Grid{5}));
}

TEST(LoadMeshopt, refusesWhatTheExtensionDoesNotAllow) {
    expectRefused(
        [] { return meshoptModel(Grid{5}); },
        {
            {"mode", setInView(0, "mode", "NEW"), "expected mode ATTRIBUTES, TRIANGLES or INDICES, found 'NEW'"},
            {"no mode", setInView(0, "mode", nullptr), "found ''"},
            {"mode of no string", setInView(0, "mode", 1), "expected a string as mode, found 1"},
            {"filter", setInView(0, "filter", "NEW"),
             "expected filter NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL or COLOR, found 'NEW'"},
            {"colors of another stride", setInView(0, "filter", "COLOR"), "that filter COLOR takes, found 12"},
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
            {"another version", [](Model& m) { m.bytes[0] = 0xa2; },
             "expected data that start with 0xa0 or 0xa1, found 0xa2"},
            {"garbage", [](Model& m) { std::fill_n(m.bytes.begin() + 1, 40, std::uint8_t{0x55}); }, "do not decode"},
        });
}

}  // namespace
}  // namespace inkedge::gltf

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
#include "formats/gltf/meshopt.h"

namespace inkedge {
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
    EXPECT_EQ(trianglesOf(loaded(model)), trianglesOf(Grid{5}));
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

}  // namespace
}  // namespace inkedge

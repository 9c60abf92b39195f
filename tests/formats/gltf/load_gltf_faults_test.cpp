#include "formats/gltf/load_gltf.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>

#include "formats/gltf/compression.h"
#include "formats/gltf/gltf_files.h"

namespace inkedge {
namespace {

using namespace gltf_files;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

using LoadGltf = GltfFileTest;

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
                for (const Mesh& mesh : gltf::loadGltf({write("model.glb", changed)}).meshes)
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
    EXPECT_THAT(refusal(model), StartsWith("node 0 'a\\nbxxx"));
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
            const int indexView = model.bufferView<std::uint8_t>({index});
            const int values = model.bufferView<float>({0, 0, 0});
            model.json["accessors"][0]["sparse"] = {
                {"count", count},
                {"indices", {{"bufferView", indexView}, {"componentType", 5121}, {"byteOffset", offset}}},
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

}  // namespace
}  // namespace inkedge

// Indices that are more than a list of vertices: with restarts, sparse, or without data.
#include "formats/gltf/gltf_files.h"
#include "formats/gltf/triangles.h"
#include "scenes.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int triangleStrip = 5;
constexpr int triangleFan = 6;

class PrimitiveRestart : public GltfFileTest {
protected:
    // A zigzag of 8 vertices and a primitive with these indices.
    template <class Index>
    static Model zigzag(int mode, const std::vector<Index>& indices,
                        const char* extension = "KHR_mesh_primitive_restart") {
        Model model;
        std::vector<float> all;
        for (int i = 0; i < 8; ++i)
            all.insert(all.end(),
                       {static_cast<float>(i / 2), static_cast<float>(i % 2), static_cast<float>(i * i % 5)});
        Json primitive = positions(model.accessor(all, "VEC3"));
        primitive["indices"] = model.accessor(indices, "SCALAR");
        primitive["mode"] = mode;
        model.root({{"mesh", model.mesh(primitive)}});
        if (extension != nullptr) {
            model.json["extensionsUsed"] = {extension};
            model.json["extensionsRequired"] = {extension};
        }
        return model;
    }
    template <class Index>
    [[nodiscard]] std::vector<std::uint32_t> drawn(int mode, const std::vector<Index>& indices) const {
        const Scene::Data data = load(zigzag(mode, indices));
        EXPECT_THAT(data.warnings, IsEmpty());
        return data.meshes.at(0).indices;
    }
};

TEST_F(PrimitiveRestart, StartsStripsAndFansAnewWhateverTheIndicesAreStoredAs) {
    const auto strips = ElementsAre(0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6);
    EXPECT_THAT(drawn<std::uint8_t>(triangleStrip, {0, 1, 2, 3, 255, 4, 5, 6, 7}), strips);
    EXPECT_THAT(drawn<std::uint16_t>(triangleStrip, {0, 1, 2, 3, 65535, 4, 5, 6, 7}), strips);
    EXPECT_THAT(drawn<std::uint32_t>(triangleStrip, {0, 1, 2, 3, 4294967295U, 4, 5, 6, 7}), strips);
    EXPECT_THAT(drawn<std::uint8_t>(triangleFan, {0, 1, 2, 3, 255, 4, 5, 6}), ElementsAre(1, 2, 0, 2, 3, 0, 5, 6, 4));
}

TEST_F(PrimitiveRestart, WindsEveryStripFromItsOwnStart) {
    // The first strip has an odd number of triangles, so that a strip that went on would be wound the other way round.
    EXPECT_THAT(drawn<std::uint8_t>(triangleStrip, {0, 1, 2, 255, 3, 4, 5}), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(PrimitiveRestart, AllowsRunsThatAreEmptyOrTooShort) {
    EXPECT_THAT(drawn<std::uint8_t>(triangleStrip, {255, 255, 0, 1, 2, 255, 255, 3, 255, 4, 5, 255, 4, 5, 6, 255}),
                ElementsAre(0, 1, 2, 4, 5, 6));
}

TEST_F(PrimitiveRestart, IsReadUnderEitherNameEvenIfOnlyUsed) {
    for (const char* extension : {"KHR_mesh_primitive_restart", "EXT_mesh_primitive_restart"}) {
        Model model = zigzag<std::uint8_t>(triangleStrip, {0, 1, 2, 255, 3, 4, 5}, extension);
        EXPECT_EQ(load(model).meshes.at(0).indices.size(), 6U) << extension;
        model.json.erase("extensionsRequired");
        EXPECT_EQ(load(model).meshes.at(0).indices.size(), 6U) << extension;
    }
}

TEST_F(PrimitiveRestart, IsRefusedWithoutTheExtensionAndWhereNothingGoesOn) {
    constexpr const char* refused = "expected vertex indices, found the primitive restart value 255 at index 3";
    const std::vector<std::uint8_t> indices{0, 1, 2, 255, 3, 4, 5};
    EXPECT_THAT(refusal(zigzag(triangleStrip, indices, nullptr)), HasSubstr(refused));
    EXPECT_THAT(refusal(zigzag(4, indices)), HasSubstr(refused));
}

TEST_F(PrimitiveRestart, DrawsThePlainPrimitivesOfEachGroup) {
    Model model = zigzag<std::uint8_t>(triangleStrip, {0, 1, 2, 3, 255, 4, 5, 6, 7}, "EXT_mesh_primitive_restart");
    Json& primitives = model.json["meshes"][0]["primitives"];
    Json& accessors = model.json["accessors"];
    for (const std::size_t begin : {0U, 5U}) {
        Json part = accessors[1];
        part["byteOffset"] = begin;
        part["count"] = 4;
        primitives.push_back(primitives[0]);
        primitives.back()["indices"] = accessors.size();
        accessors.push_back(part);
    }
    primitives.erase(0);
    model.json["meshes"][0]["extensions"]["EXT_mesh_primitive_restart"] = {
        {"primitiveGroups", {{{"primitives", {0, 1}}, {"indices", 1}}}}};
    const Scene::Data data = load(model);
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_EQ(data.meshes.at(0).indices.size(), 4U * 3U);
}

TEST_F(PrimitiveRestart, CountsTheTrianglesOfAllRunsWhereEdgesAreMarked) {
    constexpr const char* edges = "EXT_mesh_primitive_edge_visibility";
    Model model = zigzag<std::uint8_t>(triangleStrip, {0, 1, 2, 255, 3, 4, 5});
    // Two bits an edge of 2 triangles: the second's first edge is hard.
    const Json visibility{{"visibility", model.accessor<std::uint8_t>({0x80, 0}, "SCALAR")}};
    model.json["meshes"][0]["primitives"][0]["extensions"][edges] = visibility;
    EXPECT_THAT(scenes::edgesOfKind(load(model).meshes.at(0), EdgeKind::Marked),
                ElementsAre(false, false, false, true, false, false));
}

TEST(RunsOf, PartsCornersAtRestarts) {
    const std::vector<std::uint32_t> corners{restart, 1, 2, restart, restart, 3};
    std::vector<std::vector<std::uint32_t>> runs;
    for (const auto run : runsOf(corners)) runs.emplace_back(run.begin(), run.end());
    EXPECT_EQ(runs, (std::vector<std::vector<std::uint32_t>>{{1, 2}, {3}}));
    EXPECT_THAT(runsOf({}), IsEmpty());
}

class BareIndices : public GltfFileTest {
protected:
    // The square, whose second triangle's indices are the first's but for sparse ones.
    static Model sparseSquare() {
        Model model;
        Json primitive = positions(model.accessor(square, "VEC3"));
        primitive["indices"] = model.add("accessors", {{"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}});
        Json& accessor = model.json["accessors"][1];
        accessor["sparse"] = {
            {"count", 5},
            {"indices", {{"bufferView", model.bufferView<std::uint8_t>({1, 2, 3, 4, 5})}, {"componentType", 5121}}},
            {"values", {{"bufferView", model.bufferView<std::uint16_t>({1, 2, 2, 1, 3})}}}};
        model.root({{"mesh", model.mesh(primitive)}});
        return model;
    }
};

TEST_F(BareIndices, AreZerosBeforeSparseOnesArePutIn) {
    EXPECT_THAT(load(sparseSquare()).meshes.at(0).indices, ElementsAre(0, 1, 2, 2, 1, 3));
}

TEST_F(BareIndices, MayBeSharedAndOfEveryWidth) {
    Model model = sparseSquare();
    Json& mesh = model.json["meshes"][0];
    mesh["primitives"].push_back(mesh["primitives"][0]);
    EXPECT_EQ(load(model).meshes.at(0).indices.size(), 12U);
    for (const int component : {5121, 5125}) {
        Model other = sparseSquare();
        Json& accessor = other.json["accessors"][1];
        accessor["componentType"] = component;
        accessor["sparse"]["values"]["bufferView"] = component == 5121
                                                         ? other.bufferView<std::uint8_t>({1, 2, 2, 1, 3})
                                                         : other.bufferView<std::uint32_t>({1, 2, 2, 1, 3});
        EXPECT_THAT(load(other).meshes.at(0).indices, ElementsAre(0, 1, 2, 2, 1, 3)) << component;
    }
}

TEST_F(BareIndices, MakeNoTriangleIfAllAreZeros) {
    Model model = sparseSquare();
    model.json["accessors"][1].erase("sparse");
    EXPECT_THAT(load(model).meshes, IsEmpty());
}

TEST_F(BareIndices, TakeNoMoreMemoryThanTheFileIsLarge) {
    Model model = sparseSquare();
    model.json["accessors"][1]["count"] = 100'000;
    EXPECT_THAT(refusal(model), HasSubstr("accessor 1: expected at most 65536 elements without data, found 100000"));
}

}  // namespace
}  // namespace inkedge::gltf

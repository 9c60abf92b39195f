// Lines that a file has besides triangles.
#include "formats/gltf/line_pieces.h"

#include "formats/gltf/gltf_files.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int lines = 1;
constexpr int lineLoop = 2;
constexpr int lineStrip = 3;

// The square's corners.
const glm::dvec3 a{0, 0, 0};
const glm::dvec3 b{1, 0, 0};
const glm::dvec3 c{0, 1, 0};
const glm::dvec3 d{1, 1, 0};

class GltfLines : public GltfFileTest {
protected:
    // The ends of all pieces in world space.
    [[nodiscard]] std::vector<glm::dvec3> drawn(const Model& model, const LoadSettings& settings = {}) const {
        const Scene::Data data = load(model, settings);
        EXPECT_THAT(data.warnings, IsEmpty());
        std::vector<glm::dvec3> ends;
        for (const Instance& instance : data.instances)
            for (const glm::dvec3 end : lineEnds(data.meshes.at(instance.mesh)))
                ends.emplace_back(instance.transform * glm::dvec4{end, 1.0});
        return ends;
    }
};

// Lines through the square's corners.
template <class Index = std::uint16_t>
Model linesOf(int mode, const std::vector<Index>& indices = {}) {
    Model model;
    Json primitive = positions(model.accessor(square, "VEC3"));
    primitive["mode"] = mode;
    if (!indices.empty()) primitive["indices"] = model.accessor(indices, "SCALAR");
    model.root({{"mesh", model.mesh(primitive)}});
    return model;
}

Json& primitiveOf(Model& model) { return model.json["meshes"][0]["primitives"][0]; }

TEST_F(GltfLines, AreReadInEveryMode) {
    expectNear(drawn(linesOf(lines)), {a, b, c, d});
    expectNear(drawn(linesOf(lineLoop)), {a, b, b, c, c, d, d, a});
    expectNear(drawn(linesOf(lineStrip)), {a, b, b, c, c, d});
    expectNear(drawn(linesOf<std::uint16_t>(lines, {3, 0})), {d, a});
    expectNear(drawn(linesOf<std::uint8_t>(lineLoop, {3, 0})), {d, a});
    expectNear(drawn(linesOf<std::uint32_t>(lineStrip, {3, 0, 2})), {d, a, a, c});
    EXPECT_THAT(drawn(linesOf<std::uint16_t>(lineStrip, {3})), IsEmpty());
}

TEST_F(GltfLines, StandBesideTrianglesOfTheirMesh) {
    Model model = indexedTriangle();
    Json primitive = positions(model.accessor(square, "VEC3"));
    primitive["mode"] = lineStrip;
    model.json["meshes"][0]["primitives"].push_back(primitive);
    primitive["mode"] = lines;
    model.json["meshes"][0]["primitives"].insert(model.json["meshes"][0]["primitives"].begin(), primitive);
    const Scene::Data data = load(model);
    ASSERT_THAT(data.meshes, SizeIs(1));
    EXPECT_THAT(data.meshes[0].indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(data.meshes[0].positions, SizeIs(3));
    expectNear(lineEnds(data.meshes[0]), {a, b, c, d, a, b, b, c, c, d});
}

TEST_F(GltfLines, StartAnewAtARestart) {
    for (const char* extension : {"KHR_mesh_primitive_restart", "EXT_mesh_primitive_restart"}) {
        Model strip = linesOf<std::uint16_t>(lineStrip, {0, 1, 65535, 65535, 2, 3, 0, 65535, 1});
        strip.json["extensionsUsed"] = {extension};
        expectNear(drawn(strip), {a, b, c, d, d, a});
        Model loop = linesOf<std::uint8_t>(lineLoop, {0, 1, 2, 255, 2, 3});
        loop.json["extensionsUsed"] = {extension};
        expectNear(drawn(loop), {a, b, b, c, c, a, c, d});
    }
}

TEST_F(GltfLines, OfAnOddNumberOfCornersLackTheLastWithAWarning) {
    const Scene::Data data = load(linesOf<std::uint16_t>(lines, {0, 1, 2}));
    EXPECT_THAT(data.warnings,
                ElementsAre("mesh 0, primitive 0: expected a multiple of 2 corners, found 3: the last is not drawn"));
    expectNear(lineEnds(data.meshes.at(0)), {a, b});
}

TEST_F(GltfLines, AreFramedAndInTheirPose) {
    Model model;
    Json primitive = positions(model.accessor<float>({5, 0, 0, 7, 0, 0}, "VEC3"));
    primitive["mode"] = lines;
    primitive["targets"] = {{{"POSITION", model.accessor<float>({0, 2, 0, 0, 2, 0}, "VEC3")}}};
    model.root({{"mesh", model.mesh(primitive)}, {"weights", {0.5}}});
    expectNear(drawn(model), {{5, 1, 0}, {7, 1, 0}});
    const Scene scene{load(model)};
    EXPECT_EQ(scene.triangleCount(), 0U);
    EXPECT_EQ(scene.bounds().centre, (glm::dvec3{6, 1, 0}));
    EXPECT_DOUBLE_EQ(scene.bounds().radius, 1.0);
}

TEST_F(GltfLines, HangOnTheJointsOfASkin) {
    Model model = linesOf<std::uint16_t>(lines, {0, 1});
    Json& attributes = primitiveOf(model)["attributes"];
    attributes["JOINTS_0"] = model.accessor<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    attributes["WEIGHTS_0"] = model.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const int still = model.root({{"name", "still"}});
    const int lift = model.root({{"translation", {0, 0, 3}}});
    model.add("skins", {{"joints", {still, lift}}});
    model.json["nodes"][0]["skin"] = 0;
    expectNear(drawn(model), {a, b + glm::dvec3{0, 0, 3}});
}

TEST_F(GltfLines, FollowAnAnimation) {
    Model model = linesOf<std::uint16_t>(lines, {0, 1});
    const int times = model.accessor<float>({0, 1}, "SCALAR");
    model.json["accessors"][static_cast<std::size_t>(times)].update({{"min", {0}}, {"max", {1}}});
    const int translations = model.accessor<float>({0, 0, 0, 0, 4, 0}, "VEC3");
    model.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                             {"samplers", {{{"input", times}, {"output", translations}}}}});
    LoadSettings settings;
    settings.animation = "0";
    settings.time = 0.5;
    expectNear(drawn(model, settings), {a + glm::dvec3{0, 2, 0}, b + glm::dvec3{0, 2, 0}});
}

TEST_F(GltfLines, AreDrawnForEachInstance) {
    Model model = linesOf<std::uint16_t>(lines, {0, 1});
    const Json attributes{{"TRANSLATION", model.accessor<float>({1, 0, 0, 0, 2, 0}, "VEC3")},
                          {"SCALE", model.accessor<float>({1, 1, 1, 2, 2, 2}, "VEC3")}};
    model.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    expectNear(drawn(model), {{1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}});
}

TEST_F(GltfLines, MayBeQuantized) {
    Model model;
    Json primitive = positions(model.accessor<std::int16_t>({0, 0, 0, 300, 0, -300}, "VEC3"));
    primitive["mode"] = lines;
    model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    model.root({{"mesh", model.mesh(primitive)}, {"scale", {0.01, 0.01, 0.01}}});
    expectNear(drawn(model), {{0, 0, 0}, {3, 0, -3}});
}

TEST_F(GltfLines, AreMaskedByTheOpacityOfMaterialAndVertices) {
    const auto masked = [&](double opacity, const std::vector<float>& ofVertices) {
        Model model = linesOf(lines);
        std::vector<float> colors;
        for (const float alpha : ofVertices) colors.insert(colors.end(), {0, 0, 0, alpha});
        if (!colors.empty()) primitiveOf(model)["attributes"]["COLOR_0"] = model.accessor(colors, "VEC4");
        primitiveOf(model)["material"] =
            model.add("materials", {{"alphaMode", "MASK"},
                                    {"alphaCutoff", 0.5},
                                    {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, opacity}}}}});
        return model;
    };
    expectNear(drawn(masked(0.5, {})), {a, b, c, d});
    EXPECT_THAT(drawn(masked(0.4, {})), IsEmpty());
    expectNear(drawn(masked(1.0, {1, 0, 0, 0})), {a, {0.5, 0, 0}});
    expectNear(drawn(masked(0.5, {0, 0, 0, 2})), {{0.5, 1, 0}, d});
    LoadSettings whole;
    whole.alphaMask = AlphaMask::Ignore;
    expectNear(drawn(masked(0.4, {}), whole), {a, b, c, d});
}

TEST_F(GltfLines, CountForTheLimitOfVertices) {
    Model model = linesOf(lineLoop);
    LoadSettings settings;
    settings.limits.vertices = 12;  // four vertices and the ends of four pieces
    EXPECT_THAT(drawn(model, settings), SizeIs(8));
    settings.limits.vertices = 11;
    EXPECT_THAT(refusal(model, settings), HasSubstr("raise max-vertices"));
}

TEST_F(GltfLines, AreRefusedWithIndicesOutOfRange) {
    EXPECT_THAT(refusal(linesOf<std::uint16_t>(lines, {0, 4})), HasSubstr("mesh 0, primitive 0"));
    EXPECT_THAT(refusal(linesOf<std::uint16_t>(lines, {0, 65535})), HasSubstr("mesh 0, primitive 0"));
}

}  // namespace
}  // namespace inkedge::gltf

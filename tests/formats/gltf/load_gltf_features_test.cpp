#include <cmath>

#include <png.h>
#include <webp/encode.h>

#include <inkedge/scene.h>

#include "formats/gltf/gltf_files.h"
#include "mesh/topology.h"

namespace inkedge::gltf {
namespace {

using namespace gltf_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// ---- scenes and visibility

using SceneChoice = GltfFileTest;

TEST_F(SceneChoice, DrawsTheSceneAskedFor) {
    Model model = triangle();
    const int position = model.accessor<float>({5, 0, 0, 6, 0, 0, 5, 1, 0}, "VEC3");
    const int node = model.add("nodes", {{"mesh", model.mesh(positions(position))}});
    model.add("scenes", {{"nodes", {node}}, {"name", "second"}});
    LoadSettings settings;
    settings.scene = 1;
    EXPECT_DOUBLE_EQ(worldCorners(load(model, settings)).at(0).x, 5.0);
    EXPECT_THAT(load(model).source.scenes, ElementsAre("", "second"));
    settings.scene = 2;
    EXPECT_EQ(refusal(model, settings, Error::Kind::Usage), "--scene: expected a scene below 2, found 2");
}

TEST_F(SceneChoice, LeavesHiddenNodesAndTheirChildrenOut) {
    Model model = triangle();
    model.json["nodes"][0]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
    model.json["nodes"][0]["children"] = {model.add("nodes", {{"mesh", 0}, {"name", "child"}})};
    model.json["extensionsUsed"] = {"KHR_node_visibility"};
    model.root({{"mesh", 0}, {"name", "shown"}});
    const Scene::Data data = load(model);
    ASSERT_THAT(data.instances, SizeIs(1));
    EXPECT_EQ(data.instances[0].name, "shown");
    EXPECT_THAT(data.warnings, IsEmpty());
}

TEST_F(SceneChoice, KeepsNodesWhoseVisibilityIsNoObject) {
    for (const Json& extension : {Json::array({false}), Json(false)}) {
        Model model = triangle();
        model.json["nodes"][0]["extensions"]["KHR_node_visibility"] = extension;
        EXPECT_THAT(load(model).instances, SizeIs(1)) << extension;
    }
}

TEST_F(SceneChoice, WarnsOfExtensionsThatAreUsedButNotRead) {
    Model model = triangle();
    model.json["extensionsUsed"] = {"ACME_mesh_fur", "KHR_materials_sheen", "ACME_fur"};
    EXPECT_THAT(load(model).warnings,
                ElementsAre("uses extensions that this version does not read: ACME_mesh_fur, ACME_fur"));
}

TEST_F(SceneChoice, IsSilentOnExtensionsThatCannotChangeTheDrawing) {
    Model model = triangle();
    model.json["extensionsUsed"] = {"EXT_mesh_manifold",
                                    "MSFT_lod",
                                    "KHR_lights_punctual",
                                    "EXT_lights_ies",
                                    "ADOBE_materials_thin_transparency",
                                    "KHR_xmp_json_ld",
                                    "KHR_audio_emitter",
                                    "OMI_physics_body",
                                    "KHR_physics_rigid_bodies",
                                    "EXT_structural_metadata",
                                    "EXT_mesh_features",
                                    "AGI_articulations",
                                    "KHR_interactivity",
                                    "MSFT_packing_normalRoughnessMetallic"};
    model.json["extensionsRequired"] = {"EXT_mesh_manifold"};
    const Scene::Data data = load(model);
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_THAT(data.instances, SizeIs(1));
}

// ---- materials

// A PNG of grey and alpha.
Bytes png(int width, int height, const std::vector<std::uint8_t>& alpha) {
    Bytes pixels;
    for (const std::uint8_t a : alpha) pixels.insert(pixels.end(), {128, a});
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_GA;
    png_alloc_size_t size = 0;
    EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr), 0);
    Bytes bytes(size);
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr), 0);
    return bytes;
}

double areaOf(const Scene::Data& data) {
    const std::vector<glm::dvec3> corners = worldCorners(data);
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        area += 0.5 * glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
    return area;
}

class Materials : public GltfFileTest {
protected:
    // A square of side 1 with texture coordinates 0..1 and a material.
    static Model textured(const Json& material) {
        Model model;
        Json primitive = positions(model.accessor<float>(square, "VEC3"));
        primitive["attributes"]["TEXCOORD_0"] = model.accessor<float>({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
        primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
        primitive["material"] = model.add("materials", material);
        model.root({{"mesh", model.mesh(primitive)}});
        return model;
    }

    static Model cutOut(const Bytes& picture, const Json& more = Json::object()) {
        Json texture{{"index", 0}};
        texture.update(more);
        Model model = textured({{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", texture}}}});
        model.add("textures", {{"source", 0}});
        model.add("images", {{"bufferView", model.bufferView(picture)}, {"mimeType", "image/png"}});
        return model;
    }

    // The left half is there; the last texel column of it is the outline's.
    static Bytes leftHalf() {
        std::vector<std::uint8_t> alpha;
        for (int i = 0; i < 64; ++i) alpha.push_back(i % 8 < 4 ? 255 : 0);
        return png(8, 8, alpha);
    }
};

TEST_F(Materials, MasksCutTheMesh) {
    // Wrapping repeats: the outline crosses between texels 3 and 4 and between 7 and 8, at u = 0 and 1.
    const double threshold = 0.5 * 255.0;
    const double crossing = (3.5 + (255.0 - threshold) / 255.0) / 8.0;
    const double before = (7.5 + threshold / 255.0) / 8.0 - 1.0;
    const Scene::Data data = load(cutOut(leftHalf()));
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_NEAR(areaOf(data), crossing - std::max(before, 0.0), 1e-6);
    for (const glm::dvec3& corner : worldCorners(data)) EXPECT_LE(corner.x, crossing + 1e-6);
}

TEST_F(Materials, MasksHonourTransformAndWrap) {
    const Json shifted{{"extensions", {{"KHR_texture_transform", {{"offset", {0.25, 0}}}}}}};
    const Scene::Data moved = load(cutOut(leftHalf(), shifted));
    double farthest = 0.0;
    for (const glm::dvec3& corner : worldCorners(moved))
        if (corner.x < 0.7) farthest = std::max(farthest, corner.x);
    EXPECT_NEAR(farthest, 0.25, 1e-6);

    Model clamped = cutOut(leftHalf(), {{"extensions", {{"KHR_texture_transform", {{"offset", {-1, 0}}}}}}});
    EXPECT_NEAR(areaOf(load(clamped)), 0.5, 1e-6) << "repeated";
    clamped.json["textures"][0]["sampler"] = clamped.add("samplers", {{"wrapS", 33071}});
    EXPECT_NEAR(areaOf(load(clamped)), 1.0, 1e-6) << "clamped: all of it lies left of the picture";
}

TEST_F(Materials, MasksCompareTheFactorWithTheCutoff) {
    Model model = textured({{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.3}}}}});
    EXPECT_THAT(load(model).meshes, IsEmpty());
    model.json["materials"][0]["alphaCutoff"] = 0.3;
    EXPECT_NEAR(areaOf(load(model)), 1.0, 1e-6);
}

TEST_F(Materials, OpaquePicturesCutNothing) {
    const Scene::Data data = load(cutOut(png(4, 4, std::vector<std::uint8_t>(16, 255))));
    EXPECT_NEAR(areaOf(data), 1.0, 1e-6);
}

// What is missing of a picture must not cost the model.
TEST_F(Materials, PicturesThatCannotBeReadLeaveTheMeshWhole) {
    const auto warningOf = [&](const Model& model, const LoadSettings& settings = {}) {
        const Scene::Data data = load(model, settings);
        EXPECT_NEAR(areaOf(data), 1.0, 1e-6);
        EXPECT_THAT(data.warnings, SizeIs(1));
        return data.warnings.empty() ? std::string{} : data.warnings[0];
    };
    Model missing = cutOut(leftHalf());
    missing.json["images"][0] = {{"uri", "leaf.png"}};
    EXPECT_THAT(warningOf(missing),
                HasSubstr("material 0 is drawn without its cut-out: image 0: expected the file 'leaf.png'"));
    missing.json["images"][0] = {{"uri", "../../leaf.png"}};
    EXPECT_THAT(warningOf(missing), HasSubstr("expected a file within the model's folder"));
    Bytes damaged = leftHalf();
    damaged.resize(40);
    EXPECT_THAT(warningOf(cutOut(damaged)), HasSubstr("expected a PNG picture, found"));
    EXPECT_THAT(warningOf(cutOut(Bytes{'R', 'I', 'F', 'F', 0, 0})), HasSubstr("expected a PNG, JPEG or WebP picture"));
    LoadSettings small;
    small.limits.imagePixels = 63;
    EXPECT_THAT(warningOf(cutOut(leftHalf()), small),
                HasSubstr("expected at most 63 pixels, found 8x8; raise max-image-pixels"));
    Model nowhere = cutOut(leftHalf());
    nowhere.json["textures"][0] = Json::object();
    EXPECT_THAT(warningOf(nowhere), HasSubstr("expected its picture as PNG, JPEG or WebP, found none"));
}

TEST_F(Materials, NoFormOfPictureCostsTheModel) {
    LoadSettings painted;
    painted.paint = true;
    for (const char* form : {"KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds", "EXT_texture_astc",
                             "ACME_texture_new", "KHR_image_ktx2"}) {
        Model model = cutOut(leftHalf());
        model.json["textures"][0] = {{"extensions", {{form, {{"source", 0}}}}}};
        model.json["extensionsUsed"] = {form};
        model.json["extensionsRequired"] = {form};
        for (const LoadSettings& settings : {LoadSettings{}, painted}) {
            const Scene::Data data = load(model, settings);
            EXPECT_NEAR(areaOf(data), 1.0, 1e-6) << form;
            EXPECT_THAT(data.warnings, ElementsAre(HasSubstr(std::string{"in another form only, by "} + form)));
        }
        model.json["materials"][0]["alphaMode"] = "OPAQUE";
        EXPECT_THAT(load(model).warnings, IsEmpty()) << form;
        model.json["textures"][0]["source"] = 0;
        model.json["materials"][0]["alphaMode"] = "MASK";
        EXPECT_LT(areaOf(load(model)), 0.6) << form << " beside a PNG";
    }
}

TEST_F(Materials, MasksAndPaintsMayBeWebp) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), {9, 8, 7, static_cast<std::uint8_t>(i % 8 < 4 ? 255 : 1)});
    std::uint8_t* bytes = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), 8, 8, 32, &bytes);
    Model model = cutOut(Bytes{bytes, bytes + size});
    WebPFree(bytes);
    model.json["images"][0]["mimeType"] = "image/webp";
    model.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    model.json["extensionsRequired"] = {"EXT_texture_webp"};
    LoadSettings painted;
    painted.paint = true;
    const Scene::Data data = load(model, painted);
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_NEAR(areaOf(data), 0.5, 0.01);  // alpha 1 is not 0
    ASSERT_TRUE(data.materials.at(0).picture);
    EXPECT_EQ(data.materials[0].picture->pixels(), pixels);
}

// ---- opacity of vertices

// Vertices 0 and 1 have one alpha, 2 and 3 another.
void putAlpha(Model& model, float below, float above) {
    model.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
        model.accessor<float>({1, 1, 1, below, 1, 1, 1, below, 1, 1, 1, above, 1, 1, 1, above}, "VEC4");
}

TEST_F(Materials, MasksCutWhereTheOpacityOfVerticesCrossesTheCutoff) {
    Model model = textured({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}});
    putAlpha(model, 1.0F, 0.0F);
    const Scene::Data data = load(model);
    EXPECT_NEAR(areaOf(data), 0.75, 1e-6);
    for (const glm::dvec3& corner : worldCorners(data)) EXPECT_LE(corner.y, 0.75 + 1e-6);
    putAlpha(model, 1.0F, 0.25F);
    EXPECT_NEAR(areaOf(load(model)), 1.0, 1e-6);
    putAlpha(model, 0.1F, 0.2F);
    EXPECT_THAT(load(model).meshes, IsEmpty());
    model.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.5};
    putAlpha(model, 1.0F, 0.0F);
    EXPECT_NEAR(areaOf(load(model)), 0.5, 1e-6);
}

TEST_F(Materials, MasksMultiplyTheOpacityOfVerticesAndPicture) {
    // The picture's opacity falls from 1 to 0 towards the right, the vertices' from 1 to 0 upwards; texels are small
    // against both. The product is at least 0.25 where (1 - x)(1 - y) is.
    constexpr int size = 128;
    std::vector<std::uint8_t> alpha;
    for (int i = 0; i < size * size; ++i)
        alpha.push_back(static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - (i % size + 0.5) / size))));
    Model model = cutOut(png(size, size, alpha));
    model.json["materials"][0]["alphaCutoff"] = 0.25;
    model.json["textures"][0]["sampler"] = model.add("samplers", {{"wrapS", 33071}, {"wrapT", 33071}});
    putAlpha(model, 1.0F, 0.0F);
    const Scene::Data data = load(model);
    EXPECT_THAT(data.warnings, IsEmpty());
    EXPECT_NEAR(areaOf(data), 0.75 + 0.25 * std::log(0.25), 0.5 / size);  // half a texel along the outline
    for (const glm::dvec3& c : worldCorners(data)) EXPECT_GE((1.0 - c.x) * (1.0 - c.y), 0.25 - 0.5 / size);
}

TEST_F(Materials, OpacityOfVerticesThatIsNoNumberLeavesTheMeshWhole) {
    Model model = textured({{"alphaMode", "MASK"}});
    putAlpha(model, std::numeric_limits<float>::quiet_NaN(), 0.0F);
    const Scene::Data data = load(model);
    EXPECT_NEAR(areaOf(data), 1.0, 1e-6);
    EXPECT_THAT(data.warnings, ElementsAre(HasSubstr("COLOR_0: expected finite numbers, found nan as alpha")));
}

TEST_F(Materials, BlendIsSolidUnlessIgnored) {
    const Model model = textured({{"alphaMode", "BLEND"}, {"name", "glass"}});
    EXPECT_NEAR(areaOf(load(model)), 1.0, 1e-6);
    LoadSettings settings;
    settings.transparent = Transparent::Ignore;
    EXPECT_THAT(load(model, settings).meshes, IsEmpty());
}

TEST_F(Materials, SidednessIsRead) {
    Model model = textured({{"name", "leaf"}, {"doubleSided", true}});
    model.add("materials", {{"name", "bark"}});
    const Scene::Data data = load(model);
    ASSERT_THAT(data.materials, SizeIs(2));
    EXPECT_TRUE(data.materials[0].doubleSided);
    EXPECT_FALSE(data.materials[1].doubleSided);
}

TEST_F(Materials, DamageIsNamed) {
    EXPECT_THAT(refusal(textured({{"alphaMode", "HOLLOW"}})),
                HasSubstr("material 0: expected OPAQUE, MASK or BLEND as alphaMode"));
    Model model = triangle();
    model.json["meshes"][0]["primitives"][0]["material"] = 3;
    EXPECT_THAT(load(model).warnings, ElementsAre("mesh 0, primitive 0: expected a material below 0, found 3"));
}

// ---- limits

TEST_F(GltfFileTest, EveryLimitIsSaidWithTheSettingThatRaisesIt) {
    struct Case {
        std::uint64_t LoadLimits::*limit;
        std::uint64_t enough;
        std::string message;
    };
    Model model = indexedTriangle();
    model.json["nodes"][0]["children"] = {model.add("nodes", {{"mesh", 0}})};
    const std::string text = model.gltf();
    const std::vector<Case> cases{
        {&LoadLimits::fileSize, text.size(), "raise max-file-size"},
        {&LoadLimits::vertices, 6,
         "expected at most 5 vertices and indices in the scene, found more; raise max-vertices"},
        {&LoadLimits::instances, 2, "expected at most 1 instances in the scene, found more; raise max-instances"},
        {&LoadLimits::nodes, 2, "expected at most 1 nodes, found 2; raise max-nodes"},
        {&LoadLimits::nodeDepth, 2, "expected nodes at most 1 deep, found deeper; raise max-node-depth"},
    };
    for (const Case& c : cases) {
        LoadSettings settings;
        settings.limits.*c.limit = c.enough;
        EXPECT_THAT(load(model, settings).instances, SizeIs(2)) << c.message;
        settings.limits.*c.limit = c.enough - 1;
        EXPECT_THAT(refusal(model, settings), HasSubstr(c.message));
    }
}

TEST_F(GltfFileTest, ASmallFileMayNotAskForMuchMemory) {
    Model model = triangle();
    model.json["accessors"][0].erase("bufferView");
    model.json["accessors"][0]["count"] = 100'000;
    EXPECT_THAT(refusal(model), HasSubstr("expected at most 65536 elements without data, found 100000"));
    model.json["accessors"][0]["count"] = 100'000'000;
    EXPECT_THAT(refusal(model), HasSubstr("vertices and indices from so small a file"));
}

}  // namespace
}  // namespace inkedge::gltf

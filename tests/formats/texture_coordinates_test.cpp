// Texture coordinates on their way from the file into the scene.
#include <inkedge/load_scene.h>

#include "formats/gltf/gltf_files.h"

#include "scenes.h"

namespace inkedge::formats {
namespace {

using namespace gltf_files;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<float> squareCoordinates{0, 0, 1, 0, 0, 1, 1, 1};

LoadSettings reading() {
    LoadSettings settings;
    settings.textureCoordinates = true;
    return settings;
}

// That u and v are the x and y of each corner, v turned over or not.
void expectLikePositions(const Mesh& mesh, double tolerance = 1e-6) {
    ASSERT_EQ(mesh.textureCoordinates.size(), mesh.positions.size());
    for (const std::uint32_t i : mesh.indices) {
        const glm::dvec3 p = gltf_files::position(mesh, i);
        EXPECT_NEAR(double{mesh.textureCoordinates[i].x}, p.x, tolerance);
        EXPECT_NEAR(double{mesh.textureCoordinates[i].y}, p.y, tolerance);
    }
}

class TextureCoordinates : public GltfFileTest {
protected:
    template <class T>
    static Model squareWith(const std::vector<T>& coordinates, bool normalized = false) {
        Model model;
        Json primitive = positions(model.accessor(square, "VEC3"));
        primitive["indices"] = model.accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
        primitive["attributes"]["TEXCOORD_0"] = model.accessor(coordinates, "VEC2");
        if (normalized) model.json["accessors"].back()["normalized"] = true;
        model.root({{"mesh", model.mesh(primitive)}});
        return model;
    }
};

TEST_F(TextureCoordinates, AreReadOnlyWhenAskedFor) {
    EXPECT_THAT(load(squareWith(squareCoordinates)).meshes.at(0).textureCoordinates, IsEmpty());
    expectLikePositions(load(squareWith(squareCoordinates), reading()).meshes.at(0));
    EXPECT_THAT(load(indexedTriangle(), reading()).meshes.at(0).textureCoordinates, IsEmpty());
}

TEST_F(TextureCoordinates, MayBeIntegersOrSparse) {
    expectLikePositions(load(squareWith<std::uint8_t>({0, 0, 255, 0, 0, 255, 255, 255}, true), reading()).meshes.at(0));
    expectLikePositions(
        load(squareWith<std::uint16_t>({0, 0, 65535, 0, 0, 65535, 65535, 65535}, true), reading()).meshes.at(0));
    Model sparse = squareWith<float>({0, 0, 1, 0, 7, 7, 1, 1});
    const int indices = sparse.bufferView<std::uint8_t>({2});
    const int values = sparse.bufferView<float>({0, 1});
    sparse.json["accessors"][2]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", values}}}};
    expectLikePositions(load(sparse, reading()).meshes.at(0));
}

TEST_F(TextureCoordinates, ThatAreMalformedAreRefused) {
    EXPECT_THAT(refusal(squareWith<float>({0, 0, 1, 0}), reading()),
                HasSubstr("TEXCOORD_0: expected as many elements as POSITION"));
    EXPECT_THAT(refusal(squareWith<float>({0, 0, 1, 0, 0, 1, NAN, 1}), reading()),
                HasSubstr("TEXCOORD_0: expected finite numbers"));
}

TEST_F(TextureCoordinates, OfPartsWithoutAreNothing) {
    Model model = squareWith(squareCoordinates);
    Json plain = positions(0);
    plain["indices"] = 1;
    model.json["meshes"][0]["primitives"].insert(model.json["meshes"][0]["primitives"].begin(), plain);
    const Mesh mesh = load(model, reading()).meshes.at(0);
    ASSERT_EQ(mesh.textureCoordinates.size(), 8U);
    EXPECT_EQ(mesh.textureCoordinates[3], glm::vec2{0.0F});
    EXPECT_EQ(mesh.textureCoordinates[7], glm::vec2{1.0F});
}

// A roof of two slopes that share two points but not their coordinates there, an unused vertex before them.
Mesh roofWithSeam() {
    Mesh mesh;
    mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0},     {0, 1, 0},    {1, 1, 0},
                      {0, 1, 0}, {1, 1, 0}, {0, 2, -0.1F}, {1, 2, -0.1F}};
    mesh.textureCoordinates = {{9, 9}, {0, 0}, {1, 0}, {0, 1}, {1, 1}, {5, 1}, {6, 1}, {5, 2}, {6, 2}};
    mesh.indices = {1, 2, 3, 3, 2, 4, 5, 6, 7, 7, 6, 8};
    return mesh;
}

// Of each corner: what it was made with, wherever it stands now.
std::vector<glm::vec2> cornerCoordinates(const Mesh& mesh) {
    std::vector<glm::vec2> all;
    for (const std::uint32_t i : mesh.indices) all.push_back(mesh.textureCoordinates.at(i));
    return all;
}

TEST(SceneTextureCoordinates, SurviveNormalsAndDroppedVertices) {
    const Mesh mesh = roofWithSeam();
    for (const Normals normals : {Normals::Auto, Normals::Flat}) {
        LoadSettings settings;
        settings.normals = normals;
        const Scene scene = scenes::sceneOf({{mesh, glm::dmat4{1.0}}}, settings);
        EXPECT_EQ(cornerCoordinates(scene.meshes()[0]), cornerCoordinates(mesh));
        EXPECT_EQ(scene.meshes()[0].normals.size(), scene.meshes()[0].positions.size());
    }
}

TEST(SceneTextureCoordinates, SurviveDistortedInstances) {
    const Mesh mesh = roofWithSeam();
    const Scene scene = scenes::sceneOf(mesh, scenes::scaling({1, 2, 3}));
    EXPECT_EQ(cornerCoordinates(scene.meshes()[0]), cornerCoordinates(mesh));
}

TEST(SceneTextureCoordinates, AreChecked) {
    Mesh mesh = roofWithSeam();
    mesh.textureCoordinates.pop_back();
    EXPECT_THROW(scenes::sceneOf(mesh), Error);
    mesh = roofWithSeam();
    mesh.textureCoordinates[3].y = INFINITY;
    EXPECT_THROW(scenes::sceneOf(mesh), Error);
    mesh = roofWithSeam();
    mesh.edges.resize(3);
    EXPECT_THROW(scenes::sceneOf(mesh), Error);
}

class PolygonTextureCoordinates : public GltfFileTest {};

TEST_F(PolygonTextureCoordinates, OfObjAreThoseOfItsCornersTurnedOver) {
    const fs::path file = write("square.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 1\nvt 1 1 0\nvt 0\nvt 1 0\nvn 0 0 1\n"
                                "f 1/1/1 2/2/1 3/3/1\nf 3/3 2/2 4/-1\n");
    expectLikePositions(loadScene(file, reading()).meshes().at(0));
    EXPECT_THAT(loadScene(file).meshes().at(0).textureCoordinates, IsEmpty());
}

TEST_F(PolygonTextureCoordinates, OfObjThatAreMalformedAreRefused) {
    const auto refusalOf = [&](const std::string& text) -> std::string {
        try {
            static_cast<void>(loadScene(write("bad.obj", text), reading()));
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_THAT(refusalOf(vertices + "vt 0 0\nf 1/1 2/1 3/2\n"),
                HasSubstr("line 5: expected a vt from 1 to 1, found 2"));
    EXPECT_THAT(refusalOf(vertices + "vt 0 nan\nf 1/1 2/1 3/1\n"),
                HasSubstr("line 4: expected one to three finite numbers after vt"));
    EXPECT_THAT(refusalOf(vertices + "vt\nf 1/1 2/1 3/1\n"), HasSubstr("line 4: expected one to three"));
}

TEST_F(PolygonTextureCoordinates, OfPlyAreItsVertices) {
    for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
        const fs::path file = write(
            "square.ply", fmt::format("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                      "property float z\nproperty float {}\nproperty float {}\nelement face 2\n"
                                      "property list uchar int vertex_indices\nend_header\n0 0 0 0 1\n1 0 0 1 1\n"
                                      "0 1 0 0 0\n1 1 0 1 0\n3 0 1 2\n3 2 1 3\n",
                                      u, v));
        expectLikePositions(loadScene(file, reading()).meshes().at(0));
        EXPECT_THAT(loadScene(file).meshes().at(0).textureCoordinates, IsEmpty());
    }
}

}  // namespace
}  // namespace inkedge::formats

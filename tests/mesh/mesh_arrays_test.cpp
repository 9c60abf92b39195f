#include <inkedge/mesh_arrays.h>

#include <array>
#include <cstring>
#include <limits>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/scene.h>

#include "base/expect_error.h"

namespace inkedge::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A square of two triangles, 100 from the origin.
const std::vector<double> corners{100, 0, 0, 101, 0, 0, 101, 1, 0, 100, 1, 0};
const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};

MeshArrays square() {
    MeshArrays arrays;
    arrays.name = "square";
    arrays.positions = {corners.data(), NumberType::Float64, 4, 3};
    arrays.indices = {triangles.data(), NumberType::UInt32, 2, 3};
    return arrays;
}

void expectRefused(const MeshArrays& arrays, const std::string& message) {
    expectError(Error::Kind::Usage, message, [&] { static_cast<void>(makeMesh(arrays)); });
}

TEST(MeshArrays, becomeAMeshAroundItsMiddle) {
    const Mesh mesh = makeMesh(square());
    EXPECT_EQ(mesh.name, "square");
    EXPECT_EQ(mesh.origin, glm::dvec3(100.5, 0.5, 0.0));
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3{-0.5F, -0.5F, 0}, glm::vec3{0.5F, -0.5F, 0},
                                            glm::vec3{0.5F, 0.5F, 0}, glm::vec3{-0.5F, 0.5F, 0}));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(mesh.normals, IsEmpty());
    EXPECT_THAT(mesh.faces, IsEmpty());
}

TEST(MeshArrays, giveASceneThatIsDrawn) {
    Scene::Data data;
    data.meshes.push_back(makeMesh(square()));
    data.instances.push_back({"square", 0});
    const Scene scene{std::move(data)};
    EXPECT_EQ(scene.triangleCount(), 2U);
    EXPECT_EQ(scene.box().min, glm::dvec3(100, 0, 0));
    EXPECT_EQ(scene.box().max, glm::dvec3(101, 1, 0));
}

TEST(MeshArrays, keepDoublesFarFromTheOrigin) {
    const std::vector<double> far{1e9, 0, 0, 1e9 + 0.25, 0, 0, 1e9, 0.25, 0};
    MeshArrays arrays;
    arrays.positions = {far.data(), NumberType::Float64, 3, 3};
    const Mesh mesh = makeMesh(arrays);
    EXPECT_EQ(mesh.origin.x + double{mesh.positions[1].x}, 1e9 + 0.25);
}

TEST(MeshArrays, interleavedVerticesAreReadByTheirStride) {
    struct Vertex {
        std::array<float, 3> position;
        std::array<float, 3> normal;
        std::array<float, 2> coordinates;
        std::array<float, 4> color;
    };
    const std::vector<Vertex> vertices{{{0, 0, 0}, {0, 0, 2}, {0, 1}, {1, 0, 0, 1}},
                                       {{2, 0, 0}, {0, 0, 0}, {1, 1}, {0, 1, 0, 1}},
                                       {{0, 2, 0}, {3, 0, 4}, {0, 0}, {0, 0, 1, 0.5F}}};
    constexpr auto stride = static_cast<std::ptrdiff_t>(sizeof(Vertex));
    MeshArrays arrays;
    arrays.positions = {vertices[0].position.data(), NumberType::Float32, 3, 3, stride};
    arrays.normals = {vertices[0].normal.data(), NumberType::Float32, 3, 3, stride};
    arrays.textureCoordinates = {vertices[0].coordinates.data(), NumberType::Float32, 3, 2, stride};
    arrays.colors = {vertices[0].color.data(), NumberType::Float32, 3, 4, stride};
    const Mesh mesh = makeMesh(arrays);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3{-1, -1, 0}, glm::vec3{1, -1, 0}, glm::vec3{-1, 1, 0}));
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3{0, 0, 1}, glm::vec3{0}, glm::vec3{0.6F, 0, 0.8F}));
    EXPECT_THAT(mesh.textureCoordinates, ElementsAre(glm::vec2{0, 1}, glm::vec2{1, 1}, glm::vec2{0, 0}));
    ASSERT_EQ(mesh.paint.size(), 3U);
    EXPECT_EQ(mesh.paint[2].color, glm::vec4(0, 0, 1, 0.5F));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
}

TEST(MeshArrays, columnsAndBackwardRowsAreReadByTheirStrides) {
    const std::vector<float> byColumn{0, 1, 0, /**/ 0, 0, 1, /**/ 0, 0, 0};
    MeshArrays arrays;
    arrays.positions = {byColumn.data(), NumberType::Float32, 3, 3, 4, 12};
    const std::vector<std::uint16_t> backward{2, 1, 0};
    arrays.indices = {&backward[2], NumberType::UInt16, 3, 1, -2};
    const Mesh mesh = makeMesh(arrays);
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3{-0.5F, -0.5F, 0}, glm::vec3{0.5F, -0.5F, 0}, glm::vec3{-0.5F, 0.5F, 0}));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
}

TEST(MeshArrays, dataNeedNotBeAligned) {
    std::vector<unsigned char> bytes(1 + corners.size() * sizeof(double));
    std::memcpy(&bytes[1], corners.data(), corners.size() * sizeof(double));
    MeshArrays arrays = square();
    arrays.positions.data = &bytes[1];
    EXPECT_EQ(makeMesh(arrays).positions, makeMesh(square()).positions);
}

template <class Number>
Mesh withIndices(NumberType type) {
    const std::vector<Number> indices{0, 1, 2, 0, 2, 3};
    MeshArrays arrays = square();
    arrays.indices = {indices.data(), type, 6};
    return makeMesh(arrays);
}

TEST(MeshArrays, indicesMayHaveAnyWholeType) {
    const auto same = testing::ElementsAreArray(triangles);
    EXPECT_THAT(withIndices<std::uint8_t>(NumberType::UInt8).indices, same);
    EXPECT_THAT(withIndices<std::uint16_t>(NumberType::UInt16).indices, same);
    EXPECT_THAT(withIndices<std::uint32_t>(NumberType::UInt32).indices, same);
    EXPECT_THAT(withIndices<std::uint64_t>(NumberType::UInt64).indices, same);
    EXPECT_THAT(withIndices<std::int32_t>(NumberType::Int32).indices, same);
    EXPECT_THAT(withIndices<std::int64_t>(NumberType::Int64).indices, same);
}

TEST(MeshArrays, numbersOfTrianglesAndEdgesAreRead) {
    const std::array<std::int64_t, 2> faces{7, 9};
    const std::array<std::uint8_t, 2> materials{0, 1};
    const std::array<std::uint8_t, 6> edges{0, 1, 2, 2 | 32, 0, 0};
    MeshArrays arrays = square();
    arrays.faces = {faces.data(), NumberType::Int64, 2};
    arrays.materials = {materials.data(), NumberType::UInt8, 2};
    arrays.edges = {edges.data(), NumberType::UInt8, 6};
    const Mesh mesh = makeMesh(arrays);
    EXPECT_THAT(mesh.faces, ElementsAre(7, 9));
    EXPECT_THAT(mesh.materials, ElementsAre(0, 1));
    EXPECT_THAT(mesh.edges, ElementsAre(EdgeKinds{}, EdgeKind::Inner, EdgeKind::Sharp,
                                        EdgeKind::Sharp | EdgeKind::Marked, EdgeKinds{}, EdgeKinds{}));
}

TEST(MeshArrays, wrongShapesAreRefused) {
    MeshArrays arrays = square();
    arrays.positions.data = nullptr;
    expectRefused(arrays, "positions: expected data, found none");
    arrays = square();
    arrays.positions.columns = 2;
    expectRefused(arrays, "positions: expected 3 numbers a row, found 2");
    arrays = square();
    arrays.positions.type = NumberType::Int64;
    expectRefused(arrays, "positions: expected real numbers, found whole ones");
    arrays = square();
    arrays.indices.type = NumberType::Float32;
    expectRefused(arrays, "indices: expected whole numbers, found real ones");
    arrays = square();
    arrays.indices.columns = 2;
    expectRefused(arrays, "indices: expected 3 numbers a row, found 2");
    arrays = square();
    arrays.indices = {triangles.data(), NumberType::UInt32, 4};
    expectRefused(arrays, "indices: expected three a triangle, found 4");
    arrays = square();
    arrays.indices = {};
    expectRefused(arrays, "positions: expected three a triangle, as there are no indices, found 4");
    arrays = square();
    arrays.normals = {corners.data(), NumberType::Float64, 3, 3};
    expectRefused(arrays, "normals: expected 4 rows, one a position, found 3");
    arrays = square();
    arrays.faces = {triangles.data(), NumberType::UInt32, 3};
    expectRefused(arrays, "faces: expected 2 rows, one a triangle, found 3");
    arrays = square();
    arrays.edges = {triangles.data(), NumberType::UInt32, 2};
    expectRefused(arrays, "edges: expected 6 rows, one an index, found 2");
}

TEST(MeshArrays, numbersOutOfRangeAreRefused) {
    const std::vector<std::int32_t> negative{0, 1, 2, 0, -2, 3};
    MeshArrays arrays = square();
    arrays.indices = {negative.data(), NumberType::Int32, 2, 3};
    expectRefused(arrays, "indices: expected numbers from 0, found -2 in row 1");
    const std::vector<std::uint32_t> over{0, 1, 2, 0, 4, 3};
    arrays.indices = {over.data(), NumberType::UInt32, 2, 3};
    expectRefused(arrays, "indices: expected numbers below 4, found 4 in row 1");

    const std::vector<float> infinite{0, 0, 0, 1, std::numeric_limits<float>::infinity(), 0, 0, 1, 0};
    arrays = {};
    arrays.positions = {infinite.data(), NumberType::Float32, 3, 3};
    expectRefused(arrays, "positions: expected finite numbers, found (1, inf, 0) in row 1");

    arrays = square();
    arrays.colors = {corners.data(), NumberType::Float64, 4, 3};
    expectRefused(arrays, "colors: expected numbers from 0 to 1, found 100 in row 0");
    const std::vector<std::uint8_t> kinds(6, 64);
    arrays = square();
    arrays.edges = {kinds.data(), NumberType::UInt8, 6};
    expectRefused(arrays, "edges: expected numbers below 64, found 64 in row 0");
}

}  // namespace
}  // namespace inkedge::mesh

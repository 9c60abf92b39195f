#include "formats/polygons/load_polygons.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "formats/polygons/polygons.h"

namespace inkedge {
namespace {

namespace fs = std::filesystem;
using load::PolygonFormat;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

template <class T>
std::string raw(const T& value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

template <class T>
std::string raw(std::initializer_list<T> values) {
    std::string bytes;
    for (const T& value : values) bytes += raw(value);
    return bytes;
}

const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string triangleStl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid one\n";

// A binary STL of as many equal triangles.
std::string binaryStl(std::uint32_t count, const std::string& header = "") {
    std::string bytes = header;
    bytes.resize(80);
    bytes += raw(count);
    for (std::uint32_t i = 0; i < count; ++i)
        bytes += raw<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
    return bytes;
}

std::string ply(const std::string& format, const std::string& vertexProperties, const std::string& body,
                int vertices = 4, int faces = 1) {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\n{}element face {}\nproperty list uchar int "
        "vertex_indices\nend_header\n{}",
        format, vertices, vertexProperties, faces, body);
}

const std::string floatXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string squarePly = ply("ascii", floatXyz, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");

std::string binarySquarePly() {
    return ply(
        "binary_little_endian", floatXyz,
        raw<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + raw<std::uint8_t>(4) + raw<std::int32_t>({0, 1, 2, 3}));
}

class LoadPolygons : public testing::Test {
protected:
    [[nodiscard]] Scene::Data load(PolygonFormat format, const std::string& content) const {
        const fs::path file = folder_ / "model";
        put(file, content);
        return loadPolygons({file}, format);
    }
    [[nodiscard]] Scene::Data obj(const std::string& content) const { return load(PolygonFormat::Obj, content); }
    [[nodiscard]] Scene::Data stl(const std::string& content) const { return load(PolygonFormat::Stl, content); }
    [[nodiscard]] Scene::Data plyFile(const std::string& content) const { return load(PolygonFormat::Ply, content); }

    // The message with which content is refused, less the path and ": " that it starts with.
    [[nodiscard]] std::string refusal(PolygonFormat format, const std::string& content) const {
        const std::string start = (folder_ / "model").string() + ": ";
        std::string message;
        try {
            static_cast<void>(load(format, content));
            ADD_FAILURE() << "accepted: " << content.substr(0, 300);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), Error::Kind::Input);
            message = error.what();
        }
        EXPECT_THAT(message, AllOf(StartsWith(start), testing::Not(HasSubstr("\n"))));
        return message.substr(std::min(message.size(), start.size()));
    }

    TemporaryFolder folder_;
};

std::vector<glm::dvec3> corners(const Scene::Data& data) {
    const Mesh& mesh = data.meshes.at(0);
    std::vector<glm::dvec3> all;
    for (const std::uint32_t index : mesh.indices) all.push_back(mesh.origin + glm::dvec3{mesh.positions.at(index)});
    return all;
}

// The sum of the triangles' areas as vectors: the surface and its orientation, however it is cut.
glm::dvec3 area(const Scene::Data& data) {
    const std::vector<glm::dvec3> all = corners(data);
    glm::dvec3 sum{0.0};
    for (std::size_t i = 0; i < all.size(); i += 3) sum += 0.5 * glm::cross(all[i + 1] - all[i], all[i + 2] - all[i]);
    return sum;
}

double unsignedArea(const Scene::Data& data) {
    const std::vector<glm::dvec3> all = corners(data);
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); i += 3)
        sum += 0.5 * glm::length(glm::cross(all[i + 1] - all[i], all[i + 2] - all[i]));
    return sum;
}

const std::vector<glm::dvec3> triangleCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// ---- what is read

TEST_F(LoadPolygons, makesOneMeshOfAWholeFile) {
    for (const Scene::Data& data :
         {obj(triangleObj + "o b\ng c\nusemtl d\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\no e\nf 1 2 4\n"),
          stl(triangleStl + triangleStl + triangleStl)}) {
        ASSERT_THAT(data.meshes, SizeIs(1));
        ASSERT_THAT(data.instances, SizeIs(1));
        EXPECT_EQ(data.instances[0].transform, glm::dmat4{1.0});
        EXPECT_EQ(data.meshes[0].name, "model");
        EXPECT_THAT(data.meshes[0].indices, SizeIs(9));
        EXPECT_THAT(data.warnings, IsEmpty());
    }
}

TEST_F(LoadPolygons, readsEveryFlavourOfStl) {
    const std::string upperCase =
        "SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1E0 0 0\nVERTEX 0 1 0\n"
        "ENDLOOP\nENDFACET\nENDSOLID\n";
    std::string foreign = triangleStl;
    foreign.replace(6, 3, "Zähler 歯車");
    for (const std::string& content :
         {triangleStl, upperCase, foreign, "\r\n  " + triangleStl, binaryStl(1), binaryStl(1, "solid one"),
          binaryStl(1, "COLOR=abcd"), binaryStl(1, "\xff\xfe"), binaryStl(1) + "appended"})
        EXPECT_EQ(corners(stl(content)), triangleCorners) << content;
}

TEST_F(LoadPolygons, readsEveryFlavourOfPly) {
    const std::string doubles = "property double x\nproperty double y\nproperty double z\n";
    std::string bigEndian;
    for (const std::string& value : {raw(1.0F), raw(0.0F)}) bigEndian += std::string{value.rbegin(), value.rend()};
    const std::string one = bigEndian.substr(0, 4);
    const std::string zero = bigEndian.substr(4);
    const std::string bigEndianBody = zero + zero + zero + one + zero + zero + one + one + zero + zero + one + zero +
                                      std::string{"\x04\0\0\0\0\0\0\0\x01\0\0\0\x02\0\0\0\x03", 17};
    for (const std::string& content : {squarePly, binarySquarePly(), ply("binary_big_endian", floatXyz, bigEndianBody),
                                       ply("binary_little_endian", doubles,
                                           raw<double>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + raw<std::uint8_t>(4) +
                                               raw<std::int32_t>({0, 1, 2, 3}))})
        EXPECT_EQ(area(plyFile(content)), glm::dvec3(0, 0, 1)) << content;
}

TEST_F(LoadPolygons, readsObjIndicesOfEveryKind) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    for (const char* face : {"f 1 2 3", "f -3 -2 -1", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1"})
        EXPECT_EQ(corners(obj(points + face + "\n")), triangleCorners) << face;
}

TEST_F(LoadPolygons, readsNumbersOfEveryForm) {
    const std::string numbers = ".5 -.25 1.";
    const std::string more = "+5e-1 -2.5E-1 01.0";
    const std::vector<glm::dvec3> expected{{0.5, -0.25, 1}, {0.5, -0.25, 1}, {0, 0, 0}};
    EXPECT_EQ(corners(obj("v " + numbers + "\nv " + more + "\nv 0 0 0\nf 1 2 3\n")), expected);
    EXPECT_EQ(corners(plyFile(ply("ascii", floatXyz, numbers + "\n" + more + "\n0 -0 0.\n3 0 1 +2\n", 3))), expected);
    EXPECT_EQ(corners(stl("solid\nfacet normal 0 0 0\nouter loop\nvertex " + numbers + "\nvertex " + more +
                          "\nvertex 0 0 0\nendloop\nendfacet\nendsolid")),
              expected);
}

TEST_F(LoadPolygons, joinsObjLinesThatEndInABackslashAndFindsVerticesThatComeLater) {
    EXPECT_EQ(corners(obj("f 1 \\\n2 \\\r\n3\nv 0 0 0\r\nv\t1 0 +0.0 # right\nv 0 1e0 0 1 1 1")), triangleCorners);
}

TEST_F(LoadPolygons, keepsTheNormalsOfObjAndPly) {
    const Scene::Data fromObj = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\n");
    EXPECT_THAT(fromObj.meshes.at(0).normals,
                ElementsAre(glm::vec3(0, 0.6F, 0.8F), glm::vec3(0, 0.6F, 0.8F), glm::vec3(0, 0.6F, 0.8F)));
    const std::string properties = floatXyz + "property float nx\nproperty float ny\nproperty float nz\n";
    const Scene::Data fromPly =
        plyFile(ply("ascii", properties, "0 0 0 2 0 0\n1 0 0 0 0 0\n0 1 0 0 1 0\n3 0 1 2\n", 3));
    EXPECT_THAT(fromPly.meshes.at(0).normals, ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0)));
}

TEST_F(LoadPolygons, givesZeroNormalsWhereOnlySomeFacesHaveOne) {
    const Scene::Data data =
        obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\no a\nf 1//1 2//1 3//1\no b\nusemtl m\nf 1 2 3\n");
    ASSERT_THAT(data.meshes.at(0).normals, SizeIs(data.meshes.at(0).positions.size()));
    EXPECT_EQ(data.meshes[0].normals[data.meshes[0].indices[0]], glm::vec3(0, 0, 1));
    EXPECT_EQ(data.meshes[0].normals[data.meshes[0].indices[3]], glm::vec3(0, 0, 0));
}

TEST_F(LoadPolygons, dropsTheFacetNormalsOfStl) {
    EXPECT_THAT(stl(triangleStl).meshes.at(0).normals, IsEmpty());
    EXPECT_THAT(stl(binaryStl(2)).meshes.at(0).normals, IsEmpty());
}

TEST_F(LoadPolygons, numbersMaterialsInTheOrderOfTheirUse) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const Scene::Data data = obj("mtllib a.mtl\n" + points +
                                 "o c\nf 1 2 3\no d\nusemtl b\nf 1 2 4\nusemtl a\nf 1 2 3 4\nusemtl b\nf 2 3 4\n");
    std::map<std::uint32_t, int> triangles;
    for (const std::uint32_t material : data.meshes.at(0).materials) ++triangles[material];
    EXPECT_THAT(triangles, ElementsAre(testing::Pair(0, 1), testing::Pair(1, 2), testing::Pair(2, 2)));
    EXPECT_THAT(obj(triangleObj).meshes.at(0).materials, IsEmpty());
}

TEST_F(LoadPolygons, opensNoFileThatTheFileNames) {
    const fs::path pipe = folder_ / "a.mtl";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);  // would block whoever opens it
    const Scene::Data data = obj("mtllib a.mtl\nmtllib " + pipe.string() + "\n" + triangleObj);
    EXPECT_EQ(corners(data), triangleCorners);
}

TEST_F(LoadPolygons, ignoresPointsAndLinesWithOneWarning) {
    const Scene::Data data = obj(triangleObj + "p 1\nl 1 2\nl 2 3\n");
    EXPECT_EQ(corners(data), triangleCorners);
    EXPECT_THAT(data.warnings, ElementsAre("1 points and 2 lines are not drawn"));
    const Scene::Data points =
        plyFile("ply\nformat ascii 1.0\nelement vertex 2\n" + floatXyz + "end_header\n0 0 0\n1 0 0\n");
    EXPECT_THAT(points.meshes, IsEmpty());
    EXPECT_THAT(points.warnings, ElementsAre("2 points and 0 lines are not drawn"));
}

TEST_F(LoadPolygons, leavesOutTrianglesWithARepeatedVertex) {
    EXPECT_EQ(corners(plyFile(ply("ascii", floatXyz, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n", 3, 2))),
              triangleCorners);
}

TEST_F(LoadPolygons, recentresPositionsAndWarnsOfFloatsThatAreTooCoarse) {
    const Scene::Data data = obj("v 5400000 0 0\nv 5400001 0 0\nv 5400000 1 0\nf 1 2 3\n");
    EXPECT_EQ(data.meshes.at(0).origin, glm::dvec3(5400000.5, 0.5, 0));
    EXPECT_EQ(corners(data).at(1), glm::dvec3(5400001, 0, 0));
    EXPECT_THAT(data.warnings, IsEmpty());
    const std::string floats = raw<float>({5400000, 0, 0, 5400001, 0, 0, 5400000, 1, 0});
    EXPECT_THAT(
        plyFile(ply("binary_little_endian", floatXyz, floats + raw<std::uint8_t>(3) + raw<std::int32_t>({0, 1, 2}), 3))
            .warnings,
        ElementsAre("coordinates are kept to 0.64, as PLY files are read as floats: much for a model 1.41 across "
                    "that far from the origin"));
}

// ---- precision

// A millimetre's step 5,000 km from the origin: floats there are half a metre apart.
TEST_F(LoadPolygons, keepsWhatIsFinerThanFloatsFarFromTheOrigin) {
    const std::vector<glm::dvec3> corners{{5.0e6, 1.0, -4.0e6}, {5.0e6 + 0.001, 1.0, -4.0e6}, {5.0e6, 1.001, -4.0e6}};
    std::string vertices;
    std::string doubles;
    for (const glm::dvec3& c : corners) {
        vertices += fmt::format("{} {} {}\n", c.x, c.y, c.z);
        doubles += raw(c.x) + raw(c.y) + raw(c.z);
    }
    std::string objVertices;
    for (const glm::dvec3& c : corners) objVertices += fmt::format("v {} {} {}\n", c.x, c.y, c.z);
    const std::string doubleXyz = "property double x\nproperty double y\nproperty double z\n";
    const std::string binary = doubles + raw<std::uint8_t>(3) + raw<std::int32_t>({0, 1, 2});
    for (const Scene::Data& data :
         {obj(objVertices + "f 1 2 3\n"), load(PolygonFormat::Ply, ply("ascii", floatXyz, vertices + "3 0 1 2\n", 3)),
          load(PolygonFormat::Ply, ply("binary_little_endian", doubleXyz, binary, 3))}) {
        EXPECT_THAT(data.warnings, IsEmpty());
        const Mesh& mesh = data.meshes.at(0);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 found = mesh.origin + glm::dvec3{mesh.positions.at(mesh.indices.at(i))};
            EXPECT_LE(glm::distance(found, corners[i]), 1e-8) << i;  // doubles there are 1e-9 apart
        }
    }
}

// ---- polygons

TEST_F(LoadPolygons, marksTheEdgesThatOnlyCutPolygons) {
    const Mesh square = obj("v 0 0 0\nv 1 0 0\nv 1 1 0.7\nv 0 1 0\nf 1 2 3 4\n").meshes.at(0);
    ASSERT_THAT(square.indices, SizeIs(6));
    int inner = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::vec3 a = square.positions[square.indices[i]];
        const glm::vec3 b = square.positions[square.indices[i / 3 * 3 + (i + 1) % 3]];
        EXPECT_EQ(square.edges.at(i).has(EdgeKind::Inner), a.x != b.x && a.y != b.y) << i;
        inner += square.edges.at(i).has(EdgeKind::Inner) ? 1 : 0;
    }
    EXPECT_EQ(inner, 2);
    EXPECT_THAT(obj(triangleObj).meshes.at(0).edges, IsEmpty());
    // The second polygon is a triangle: all its edges are the file's.
    const Mesh mixed = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n").meshes.at(0);
    EXPECT_EQ(std::ranges::count(mixed.edges, EdgeKinds{EdgeKind::Inner}), 2);
    EXPECT_THAT(mixed.edges, SizeIs(9));
}

// An L with a corner on a straight side, at 1.
const std::string letterL = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(LoadPolygons, cutsConcavePolygonsWithinTheirOutline) {
    for (int turn = 0; turn < 8; ++turn) {
        std::string face = "f";
        for (int i = 0; i < 8; ++i) face += fmt::format(" {}", (i + turn) % 8 + 1);
        const Scene::Data data = obj(letterL + face + "\n");
        EXPECT_THAT(data.meshes.at(0).indices, SizeIs(18)) << face;
        EXPECT_EQ(area(data), glm::dvec3(0, 0, 3)) << face;
        EXPECT_EQ(unsignedArea(data), 3.0) << face;
    }
    const Scene::Data dart = obj("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(unsignedArea(dart), 1.0);
}

TEST_F(LoadPolygons, cutsPolygonsInEveryPlaneAndDirection) {
    const std::vector<std::vector<double>> polygon{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool backwards : {false, true}) {
            std::string content;
            std::string face = "f";
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                std::vector<double> point{7, 7, 7};
                point[static_cast<std::size_t>(axis + 1) % 3] = polygon[i][0];
                point[static_cast<std::size_t>(axis + 2) % 3] = polygon[i][1];
                content += fmt::format("v {}\n", fmt::join(point, " "));
                face += fmt::format(" {}", backwards ? polygon.size() - i : i + 1);
            }
            glm::dvec3 expected{0.0};
            expected[axis] = backwards ? -10.0 : 10.0;
            EXPECT_EQ(area(obj(content + face + "\n")), expected);
            EXPECT_EQ(unsignedArea(obj(content + face + "\n")), 10.0);
        }
    }
}

TEST_F(LoadPolygons, usesEveryCornerOfAPolygonSoThatNeighboursMeetIt) {
    const Scene::Data data = obj("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 0 1 0\nf 1 2 3 4 5 6\n");
    std::vector<int> uses(6);
    for (const std::uint32_t index : data.meshes.at(0).indices) ++uses.at(index);
    EXPECT_THAT(uses, Each(testing::Ge(1)));
    EXPECT_THAT(data.meshes[0].indices, SizeIs(12));
    EXPECT_EQ(unsignedArea(data), 3.0);
}

TEST_F(LoadPolygons, cutsConvexQuadsFromTheirFirstCorner) {
    const Scene::Data data = obj("v 0 0 0\nv 4 0 1\nv 4 4 0\nv 0 4 1\nf 1 2 3 4\n");
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST_F(LoadPolygons, cutsConcaveQuadsFromTheirHollowCorner) {
    const Scene::Data data = obj("v 0 0 0\nv 1 1 0\nv 4 0 0\nv 0 4 0\nf 1 2 3 4\n");
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(1, 2, 3, 1, 3, 0));
}

TEST(PolygonCutter, cutsWhateverItGetsIntoTwoTrianglesLessThanCorners) {
    load::PolygonCutter cutter;
    std::srand(7);
    const auto random = [] { return static_cast<double>(std::rand() % 9); };
    for (int round = 0; round < 2000; ++round) {
        std::vector<glm::dvec3> polygon(static_cast<std::size_t>(3 + std::rand() % 20));
        for (glm::dvec3& corner : polygon) corner = {random(), random(), round % 3 == 0 ? 0.0 : random()};
        const auto triangles = cutter.cut(polygon);
        ASSERT_EQ(triangles.size(), polygon.size() - 2);
        glm::dvec3 sum{0.0};
        glm::dvec3 expected{0.0};
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            expected += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
        for (const auto& [a, b, c] : triangles) {
            ASSERT_LT(std::max({a, b, c}), polygon.size());
            sum += glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
        }
        ASSERT_LE(glm::length(sum - expected), 1e-9);
    }
}

TEST(PolygonCutter, takesTimeInProportionToConvexPolygons) {
    std::vector<glm::dvec3> polygon;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) polygon.emplace_back(std::cos(i * 6.283 / count), std::sin(i * 6.283 / count), 0);
    EXPECT_EQ(load::PolygonCutter{}.cut(polygon).size(), count - 2);
}

TEST(PolygonCutter, cutsACombOfManyTeeth) {
    std::vector<glm::dvec3> comb;
    constexpr int teeth = 60'000;
    for (int i = 0; i < teeth; ++i) comb.insert(comb.end(), {{2 * i, 9, 0}, {2 * i + 1, i % 3, 0}});
    for (int i = teeth; i-- > 0;) comb.insert(comb.end(), {{2 * i + 1, i % 3 - 1, 0}, {2 * i, 8, 0}});
    EXPECT_EQ(load::PolygonCutter{}.cut(comb).size(), comb.size() - 2);
}

// ---- what is refused

TEST_F(LoadPolygons, refusesWhatIsNotOfTheFormat) {
    EXPECT_EQ(refusal(PolygonFormat::Obj, "no model"), "expected faces, found none");
    const std::string png = std::string{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16} + std::string(200, '\x01');
    EXPECT_EQ(refusal(PolygonFormat::Obj, png), "expected OBJ, found a zero byte at byte 8");
    EXPECT_THAT(refusal(PolygonFormat::Stl, png), StartsWith("expected 842150534 bytes for the 16843009 triangles"));
    EXPECT_EQ(refusal(PolygonFormat::Ply, png), "expected PLY, found a PNG picture");
    EXPECT_EQ(refusal(PolygonFormat::Stl, "<html>"), "expected STL, found HTML or XML");
    EXPECT_EQ(refusal(PolygonFormat::Ply, "<html>\n"), "expected PLY, found HTML or XML");
    EXPECT_EQ(refusal(PolygonFormat::Ply, "ply"), "expected end_header, found the end of the file: it is truncated");
    for (const PolygonFormat format : {PolygonFormat::Obj, PolygonFormat::Stl, PolygonFormat::Ply})
        EXPECT_EQ(refusal(format, ""), "expected a file with content, found an empty one");
}

TEST_F(LoadPolygons, refusesTruncatedStl) {
    const std::string binary = binaryStl(9);
    for (const std::size_t size : {std::size_t{1}, std::size_t{83}, std::size_t{84}, binary.size() - 1})
        EXPECT_THAT(refusal(PolygonFormat::Stl, binary.substr(0, size)), StartsWith("expected ")) << size;
    const std::size_t end = triangleStl.find("endfacet");
    for (std::size_t size = 5; size < end; ++size)
        EXPECT_THAT(refusal(PolygonFormat::Stl, triangleStl.substr(0, size)), HasSubstr("expected "));
    EXPECT_THAT(refusal(PolygonFormat::Stl, triangleStl.substr(0, end)),
                HasSubstr("the end of the file: it is truncated"));
    EXPECT_EQ(refusal(PolygonFormat::Stl, "solid\nendsolid\n"), "expected facets, found none");
    EXPECT_EQ(refusal(PolygonFormat::Stl, binaryStl(0)), "expected facets, found none");
}

TEST_F(LoadPolygons, readsStlWhoseHeaderOrEndIsWrongWithAWarning) {
    const Scene::Data open = stl(triangleStl.substr(0, triangleStl.find("endsolid")));
    EXPECT_EQ(corners(open), triangleCorners);
    EXPECT_THAT(open.warnings, ElementsAre("expected endsolid, found the end of the file: it may be truncated"));
    EXPECT_EQ(corners(stl("\xef\xbb\xbf" + triangleStl)), triangleCorners);
    for (const std::uint32_t said : {0U, 2U, 4294967295U}) {
        std::string binary = binaryStl(1);
        binary.replace(80, 4, raw(said));
        const Scene::Data data = stl(binary);
        EXPECT_EQ(corners(data), triangleCorners);
        EXPECT_THAT(data.warnings,
                    ElementsAre(fmt::format("expected {} triangles, as the header says, found 1: all are read", said)));
    }
}

TEST_F(LoadPolygons, readsPlyFacesThatComeBeforeTheirVertices) {
    const std::string header = "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n";
    const std::string square = header + "element vertex 4\n" + floatXyz + "end_header\n4 0 1 2 3\n";
    EXPECT_EQ(area(plyFile(square + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n")), glm::dvec3(0, 0, 1));
}

TEST_F(LoadPolygons, readsObjCommentsIndentationAndLineEnds) {
    for (const std::string& content : {std::string{"# a path\\\nv 0 0 0\nv 1 0 0 # b\\\nv 0 1 0\nf 1 2 3 # c\n"},
                                       std::string{"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"},
                                       std::string{"  v 0 0 0\n\tv 1 0 0\n v 0 1 0\n  f 1 2 3"}})
        EXPECT_EQ(corners(obj(content)), triangleCorners) << content;
    const Scene::Data named = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a#1\nf 1 2 3\nusemtl a#2\nf 1 3 2\n");
    EXPECT_THAT(named.meshes.at(0).materials, ElementsAre(1, 2));
}

TEST_F(LoadPolygons, refusesTruncatedPlyWhereverItIsCut) {
    for (const std::string& whole : {binarySquarePly(), squarePly.substr(0, squarePly.size() - 1)})
        for (std::size_t size = 1; size < whole.size(); ++size)
            EXPECT_THAT(refusal(PolygonFormat::Ply, whole.substr(0, size)), HasSubstr("expected ")) << size;
}

TEST_F(LoadPolygons, refusesCountsThatTheFileCannotHold) {
    const std::string huge = "4294967295";
    for (const std::string& element :
         {"vertex " + huge + "\n" + floatXyz,
          "vertex 0\n" + floatXyz + "element face " + huge + "\nproperty list uchar int vertex_indices\n"})
        for (const char* format : {"ascii", "binary_little_endian"})
            EXPECT_THAT(refusal(PolygonFormat::Ply,
                                fmt::format("ply\nformat {} 1.0\nelement {}end_header\n1 2 3\n", format, element)),
                        AllOf(StartsWith("expected 4294967295 elements"), HasSubstr("truncated")));
    EXPECT_THAT(refusal(PolygonFormat::Ply, ply("binary_little_endian", floatXyz, std::string(48, '\0') + "\xff", 4)),
                HasSubstr("truncated"));
    EXPECT_THAT(refusal(PolygonFormat::Ply, "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"),
                HasSubstr("expected the number of elements 'vertex', found '99999999999'"));
}

TEST_F(LoadPolygons, refusesMalformedPlyByLineOrElement) {
    const std::string vertices = "element vertex 0\n" + floatXyz;
    const std::string faces = "element face 0\nproperty list uchar int vertex_indices\n";
    for (const auto& [lines, expected] : std::map<std::string, std::string>{
             {"element vertex 1\n", "element 'vertex': expected properties, found none"},
             {"element vertex 0\nproperty float x\n", "element 'vertex': expected the property y, found none"},
             {vertices + vertices, "element 'vertex': expected it once, found it twice"},
             {vertices + faces + faces, "element 'face': expected it once, found it twice"},
             {vertices + "element face 0\nproperty int vertex_indices\n",
              "element 'face': expected one list vertex_indices of integers, found none or several"},
             {"property int i\n", "line 3: expected an element before its properties, found none"},
             {"element face 1\nproperty list float int i\n",
              "line 4: expected an integer as a list's length, found 'float'"},
             {"element face 1\nproperty long i\n", "line 4: expected a type of PLY, found 'long'"},
             {"end_headers\n",
              "line 3: expected format, element, property, comment or end_header, found 'end_headers'"},
             {"", "expected elements 'vertex', found none"}})
        EXPECT_EQ(refusal(PolygonFormat::Ply, "ply\nformat ascii 1.0\n" + lines + "end_header\n"), expected);
    EXPECT_EQ(refusal(PolygonFormat::Ply, "ply\nend_header\n"), "expected a format in the header, found none");
    EXPECT_EQ(refusal(PolygonFormat::Ply, ply("ascii", floatXyz, "0 0 z\n", 1, 0)),
              "expected a number of type float, found 'z'");
}

TEST_F(LoadPolygons, refusesMalformedStlByFacet) {
    std::string broken = triangleStl;
    broken.replace(broken.find("vertex 1"), 8, "vertex x");
    EXPECT_EQ(refusal(PolygonFormat::Stl, triangleStl + broken), "facet 1: expected a finite number, found 'x'");
    EXPECT_EQ(refusal(PolygonFormat::Stl, triangleStl + "more"), "expected solid or the end of the file, found 'more'");
}

TEST_F(LoadPolygons, cutsTheTriangleStripsOfPlyEveryOneOfThem) {
    const std::string header = "\nelement vertex 5\n" + floatXyz + "element tristrips 2\n";
    const std::string positions = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
    const std::string property = "property list int int vertex_indices\nend_header\n";
    const auto square = plyFile("ply\nformat ascii 1.0" + header + property + positions + "4 0 1 2 3\n4 -1 2 3 4\n");
    EXPECT_EQ(area(square), glm::dvec3(0, 0, 1.5));
    EXPECT_THAT(square.meshes.at(0).indices, SizeIs(9));

    const std::string numbers = raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const auto binary = plyFile("ply\nformat binary_little_endian 1.0" + header + property + numbers +
                                raw<std::int32_t>({8, 0, 1, 2, 3, -1, 2, 3, 4, 2, 0, 1}));
    EXPECT_EQ(area(binary), glm::dvec3(0, 0, 1.5));

    EXPECT_THAT(refusal(PolygonFormat::Ply, "ply\nformat ascii 1.0" + header + property + positions + "3 0 1 -2\n0\n"),
                HasSubstr("expected vertices from 0, or -1 between strips, found -2"));
}

TEST_F(LoadPolygons, skipsWhatPlyFilesHoldBesidesTheShape) {
    const std::string content =
        "ply\nformat ascii 1.0\ncomment \xff\nobj_info end_header\nelement odd\xc3\xa9 1\nproperty list int float "
        "many\n"
        "element vertex 3\nproperty uchar red\n" +
        floatXyz +
        "property list uchar int x\nelement face 1\nproperty int material_index\nproperty list uint short "
        "vertex_index\n"
        "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\nend_header\n"
        "2 0.5 nan\n7 0 0 0 0\n7 1 0 0 1 9\n7 0 1 0 0\n5 3 0 1 2 2 0.5 0.5\n1\n";
    EXPECT_EQ(corners(plyFile(content)), triangleCorners);
}

TEST_F(LoadPolygons, refusesFacesOfMissingVertices) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    for (const auto& [face, expected] : std::map<std::string, std::string>{
             {"1 2 9", "expected a vertex from 1 to 3, found 9"},
             {"1 2 -4", "expected a vertex from 1 or from -1 to -3, found -4"},
             {"1 2 0", "expected a vertex from 1 or from -1 to -3, found 0"},
             {"1//1 2//1 3//2", "expected a normal from 1 to 1, found 2"},
             {"1 2 x", "expected the number of a vertex, found 'x'"},
             {"1 2 99999999999999999999", "expected the number of a vertex, found '99999999999999999999'"},
             {"1/1/1/1 2 3", "expected a corner like 7, 7/8, 7/8/9 or 7//9, found '1/1/1/1'"}})
        EXPECT_EQ(refusal(PolygonFormat::Obj, points + "f " + face + "\n"), "line 5: " + expected);
    for (const char* face : {"3 0 1 4\n", "4 0 1 2 4\n", "3 0 1 -1\n"})
        EXPECT_THAT(
            refusal(PolygonFormat::Ply, ply("ascii", floatXyz, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + std::string{face})),
            HasSubstr("expected vertices below 4, found 4"));
}

TEST_F(LoadPolygons, refusesPositionsThatAreNotFiniteByMeshAndVertex) {
    std::string broken = binaryStl(2);
    const std::string nan = raw(std::numeric_limits<float>::quiet_NaN());
    broken.replace(84 + 50 + 12 + 12 + 4, 4, nan);
    EXPECT_EQ(refusal(PolygonFormat::Stl, broken), "expected finite positions, found (1, nan, 0) at vertex 4");
    for (const char* number : {"nan", "inf", "-1e39", "1e999", "1,5", "0x1p"})
        EXPECT_EQ(refusal(PolygonFormat::Obj, fmt::format("v 0 0 0\n\nv 1 {} 0\nv 0 1 0\nf 1 2 3\n", number)),
                  fmt::format("line 3: expected three finite numbers after v, found 1 and '{}'", number));
}

// Every byte of small files is changed in several ways: each ends in a model or in one line.
TEST_F(LoadPolygons, survivesEveryChangedByte) {
    const std::map<PolygonFormat, std::vector<std::string>> files{
        {PolygonFormat::Obj, {"mtllib m\n" + letterL + "vn 0 0 1\nusemtl a\nf 1//1 2//1 3//1 4//1 5//1\nl 1 2\n"}},
        {PolygonFormat::Stl, {triangleStl, binaryStl(1)}},
        {PolygonFormat::Ply, {squarePly, binarySquarePly()}},
    };
    for (const auto& [format, contents] : files) {
        for (const std::string& content : contents) {
            for (std::size_t i = 0; i < content.size(); ++i) {
                for (const char changed : {'\n', '9', '\xff'}) {
                    std::string hostile = content;
                    hostile[i] = changed;
                    try {
                        static_cast<void>(load(format, hostile));
                    } catch (const Error& error) {
                        EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
                    }
                }
            }
        }
    }
}

// ---- real models

fs::path modelFolder() {
    const char* const set = std::getenv("INKEDGE_MODELS");
    return set != nullptr ? fs::path{set} : fs::path{INKEDGE_SOURCE_DIR}.parent_path() / "shared" / "models";
}

// The folder's MODELS.tsv: file, source, licence, triangles, what is special.
TEST_F(LoadPolygons, readsRealModelsWithTheTrianglesThatTheirTableSays) {
    std::ifstream table{modelFolder() / "MODELS.tsv"};
    if (!table)
        GTEST_SKIP() << "NO REAL MODEL IS TESTED: " << modelFolder() << " holds no MODELS.tsv; set INKEDGE_MODELS";
    int count = 0;
    for (std::string line; std::getline(table, line);) {
        std::istringstream stream{line};
        std::vector<std::string> fields;
        for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
        ASSERT_GE(fields.size(), 5U) << line;
        const fs::path file = modelFolder() / fields[0];
        if (file.extension() == ".glb" || file.extension() == ".gltf" || file.extension().empty()) continue;
        ++count;
        EXPECT_EQ(std::to_string(loadScene(file).triangleCount()), fields[3]) << fields[0];
    }
    EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace inkedge

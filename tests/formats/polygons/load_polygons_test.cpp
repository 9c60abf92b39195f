#include "formats/polygons/load_polygons.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "formats/polygons/polygon_files.h"

namespace inkedge::polygons {
namespace {

namespace fs = std::filesystem;
using namespace polygon_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

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

std::vector<glm::dvec3> lineEnds(const Scene::Data& data) {
    EXPECT_THAT(data.warnings, IsEmpty());
    const Mesh& mesh = data.meshes.at(0);
    std::vector<glm::dvec3> positions;
    for (const glm::vec3 p : mesh.lines) positions.push_back(mesh.origin + glm::dvec3{p});
    return positions;
}

const glm::dvec3 corner0{0, 0, 0};
const glm::dvec3 corner1{4, 0, 0};
const glm::dvec3 corner2{4, 2, 0};
const std::string obtuse = "v 0 0 0\nv 4 0 0\nv 4 2 0\nvt 0 0\nvn 0 0 1\n";  // corner0 to corner2

TEST_F(LoadPolygons, readsTheLinesOfObj) {
    const Scene::Data alone = obj("l 1 2\n" + obtuse + "l 2/1 3/1 -3\nl 1\n");
    EXPECT_THAT(alone.meshes.at(0).indices, IsEmpty());
    EXPECT_THAT(lineEnds(alone), ElementsAre(corner0, corner1, corner1, corner2, corner2, corner0));
    const Scene::Data beside = obj(obtuse + "l 1 3\nf 1/1/1 2/1/1 3/1/1\nl -3 -2\n");
    EXPECT_EQ(corners(beside), (std::vector<glm::dvec3>{corner0, corner1, corner2}));
    EXPECT_THAT(lineEnds(beside), ElementsAre(corner0, corner2, corner0, corner1));
    EXPECT_EQ(Scene{beside}.meshes()[0].positions.size(), 3U);
}

TEST_F(LoadPolygons, readsTheEdgesOfPly) {
    const std::string vertices = "element vertex 3\n" + floatXyz;
    const std::string edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty uchar red\n";
    const std::string coordinates = "0 0 0\n4 0 0\n4 2 0\n";
    const std::string text = "ply\nformat ascii 1.0\n";
    EXPECT_THAT(lineEnds(plyFile(text + vertices + edges + "end_header\n" + coordinates + "0 1 255\n2 1 0\n")),
                ElementsAre(corner0, corner1, corner2, corner1));
    EXPECT_THAT(lineEnds(plyFile(text + edges + vertices + "end_header\n0 1 255\n2 1 0\n" + coordinates)),
                ElementsAre(corner0, corner1, corner2, corner1));
}

TEST_F(LoadPolygons, readsFacesOfTwoCornersAsLines) {
    EXPECT_THAT(lineEnds(obj(obtuse + "f 1//1 3//1\n")), ElementsAre(corner0, corner2));
    EXPECT_THAT(lineEnds(plyFile(ply("ascii", floatXyz, "0 0 0\n4 0 0\n4 2 0\n2 1 2\n", 3))),
                ElementsAre(corner1, corner2));
}

TEST_F(LoadPolygons, ignoresPointsWithOneWarning) {
    const Scene::Data data = obj(triangleObj + "p 1\n");
    EXPECT_EQ(corners(data), triangleCorners);
    EXPECT_THAT(data.warnings, ElementsAre("1 point is not drawn"));
    const Scene::Data points =
        plyFile("ply\nformat ascii 1.0\nelement vertex 2\n" + floatXyz + "end_header\n0 0 0\n1 0 0\n");
    EXPECT_THAT(points.meshes, IsEmpty());
    EXPECT_THAT(points.warnings, ElementsAre("2 points are not drawn"));
}

TEST_F(LoadPolygons, sayWhatThereIsInsteadOfTriangles) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_THAT(obj(points).undrawn, ElementsAre("3 points"));
    EXPECT_THAT(obj(points + "p 1 2\np 3\n").undrawn, ElementsAre("3 points"));
    EXPECT_THAT(obj(points + "p 1\nl 1 2\n").undrawn, IsEmpty());
    EXPECT_THAT(plyFile(ply("ascii", floatXyz, "0 0 0\n1 0 0\n", 2, 0)).undrawn, ElementsAre("2 points"));
    EXPECT_THAT(plyFile(ply("ascii", floatXyz, "0 0 0\n1 0 0\n3 0 1 1\n", 2)).undrawn,
                ElementsAre("1 face of repeated vertices"));
    EXPECT_THAT(obj(triangleObj).undrawn, IsEmpty());
    for (const Scene::Data& data : {stl("solid\nendsolid\n"), stl(binaryStl(0))}) {
        EXPECT_THAT(data.instances, IsEmpty());
        EXPECT_THAT(data.undrawn, IsEmpty());
    }
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

TEST_F(LoadPolygons, readsTextWithAByteOrderMarkWhateverItsLineEnds) {
    const std::string triangle = ply("ascii", floatXyz, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3);
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const auto marked = [&](std::string text) {
            for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
                text.replace(at, 1, end);
            return "\xef\xbb\xbf" + text;
        };
        for (const Scene::Data& data :
             {obj(marked(triangleObj)), stl(marked(triangleStl)), plyFile(marked(triangle))}) {
            EXPECT_EQ(corners(data), triangleCorners);
            EXPECT_THAT(data.warnings, IsEmpty());
        }
    }
}

TEST_F(LoadPolygons, readsPlyFacesThatComeBeforeTheirVertices) {
    const std::string header = "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n";
    const std::string square = header + "element vertex 4\n" + floatXyz + "end_header\n4 0 1 2 3\n";
    EXPECT_EQ(area(plyFile(square + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n")), glm::dvec3(0, 0, 1));
    const std::string binary =
        "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar int "
        "vertex_indices\nproperty uchar flags\nelement edge 1\nproperty int vertex1\nelement "
        "vertex 3\n" +
        floatXyz + "end_header\n";
    const std::string face = raw<std::uint8_t>(3) + raw<std::int32_t>({0, 1, 2}) + '\x7f' + raw<std::int32_t>(0);
    EXPECT_EQ(corners(plyFile(binary + face + raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}))), triangleCorners);
    EXPECT_THAT(refusal(PolygonFormat::Ply, square + "0 0 0\n1 0 0\n1 1 0\n"), HasSubstr("expected "));
}

TEST_F(LoadPolygons, readsObjCommentsIndentationAndLineEnds) {
    for (const std::string& content : {std::string{"# a path\\\nv 0 0 0\nv 1 0 0 # b\\\nv 0 1 0\nf 1 2 3 # c\n"},
                                       std::string{"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"},
                                       std::string{"  v 0 0 0\n\tv 1 0 0\n v 0 1 0\n  f 1 2 3"}})
        EXPECT_EQ(corners(obj(content)), triangleCorners) << content;
    const Scene::Data named = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a#1\nf 1 2 3\nusemtl a#2\nf 1 3 2\n");
    EXPECT_THAT(named.meshes.at(0).materials, ElementsAre(1, 2));
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
}  // namespace inkedge::polygons

#include "formats/polygons/load_polygons.h"

#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "formats/polygons/polygon_files.h"

namespace inkedge::polygons {
namespace {

using namespace polygon_files;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

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
    for (const PolygonFormat format : {PolygonFormat::Obj, PolygonFormat::Stl, PolygonFormat::Ply}) {
        EXPECT_EQ(refusal(format, ""), "expected a file with content, found an empty one");
        for (const char* const mark : {"\xff\xfe", "\xfe\xff"}) {
            std::string wide = mark;
            for (const char c : triangleObj + triangleStl + squarePly) wide += {c, '\0'};
            EXPECT_THAT(refusal(format, wide), HasSubstr("found UTF-16 text"));
        }
    }
}

TEST_F(LoadPolygons, refusesLinesOfVerticesThatAreNotThere) {
    const std::string points = "v 0 0 0\nv 1 0 0\n";
    EXPECT_EQ(refusal(PolygonFormat::Obj, points + "l 1 2 3\n"), "line 3: expected a vertex from 1 to 2, found 3");
    EXPECT_EQ(refusal(PolygonFormat::Obj, points + "l 1 x\n"), "line 3: expected the number of a vertex, found 'x'");
    const std::string edge = "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
        "float z\n" +
        edge + "0 0 0\n";
    EXPECT_EQ(refusal(PolygonFormat::Ply, header + "0 1\n"), "expected vertices below 1, found 1 in line 0");
    EXPECT_THAT(refusal(PolygonFormat::Ply, header + "0\n"), HasSubstr("data for 0: the file is truncated"));
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
}

TEST_F(LoadPolygons, readsStlWhoseHeaderOrEndIsWrongWithAWarning) {
    const Scene::Data open = stl(triangleStl.substr(0, triangleStl.find("endsolid")));
    EXPECT_EQ(corners(open), triangleCorners);
    EXPECT_THAT(open.warnings, ElementsAre("expected endsolid, found the end of the file: it may be truncated"));
    const std::string solid = triangleStl.substr(0, triangleStl.find("endsolid"));
    const Scene::Data inARow = stl(solid + solid + triangleStl);
    EXPECT_EQ(inARow.meshes.at(0).indices.size(), 9U);
    EXPECT_THAT(inARow.warnings, ElementsAre("expected endsolid, found solid: what follows is read as the next solid"));
    for (const std::uint32_t said : {0U, 2U, 4294967295U}) {
        std::string binary = binaryStl(1);
        binary.replace(80, 4, raw(said));
        const Scene::Data data = stl(binary);
        EXPECT_EQ(corners(data), triangleCorners);
        EXPECT_THAT(data.warnings,
                    ElementsAre(fmt::format("expected {} triangles, as the header says, found 1: all are read", said)));
    }
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
                        HasSubstr("expected at most 134217728 vertices and corners, found more; raise max-vertices"));
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

}  // namespace
}  // namespace inkedge::polygons

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <inkedge/load_scene.h>

#include "base/expect_error.h"
#include "formats/cad/threemf_files.h"
#include "formats/cad/zip_directory.h"
#ifdef INKEDGE_3MF_LINES
#include "formats/same_lines.h"
#endif

namespace inkedge::cad {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using namespace threemf_files;

Scene sceneOf(const std::vector<std::uint8_t>& bytes, const LoadSettings& settings = {}) {
    return loadScene(bytes, "part.3mf", settings);
}
Scene sceneOf(const std::string& inside, const std::string& unit = "millimeter") {
    return sceneOf(archive(model(inside, unit)));
}

const std::string buildOne = "<build><item objectid=\"1\"/></build>";

void expectBox(const Scene& scene, glm::dvec3 low, glm::dvec3 high) {
    EXPECT_LT(glm::distance(scene.box().min, low), 1e-4 * glm::length(high));
    EXPECT_LT(glm::distance(scene.box().max, high), 1e-4 * glm::length(high));
}

TEST(Load3mf, drawsWhatItemsBuildInMillimetres) {
    const std::vector<std::pair<std::string, double>> units{{"micron", 0.001},    {"millimeter", 1.0},
                                                            {"centimeter", 10.0}, {"inch", 25.4},
                                                            {"foot", 304.8},      {"meter", 1000.0}};
    for (const auto& [unit, length] : units) {
        const Scene scene = sceneOf("<resources>" + cube(1, "name=\"cube\"") + "</resources>" + buildOne, unit);
        expectBox(scene, {0, 0, 0}, glm::dvec3{10.0 * length});
        EXPECT_EQ(scene.source().format, "3MF");
        EXPECT_EQ(scene.source().unit, LengthUnit::Millimetre);
        EXPECT_EQ(scene.up(), glm::dvec3(0, 0, 1));
        EXPECT_EQ(scene.triangleCount(), 12U);
        EXPECT_EQ(scene.instances()[0].name, "cube");
        EXPECT_THAT(scene.warnings(), IsEmpty());
    }
}

TEST(Load3mf, sharesTheMeshOfComponentsThatMoveAndMirrorIt) {
    const Scene scene =
        sceneOf("<resources>" + cube(1, "name=\"cube\"") +
                "<object id=\"2\" type=\"model\" name=\"pair\"><components><component objectid=\"1\"/>"
                "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 -5 0 0\"/></components></object></resources>"
                "<build><item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 100 0 0\"/></build>");
    ASSERT_THAT(scene.meshes(), SizeIs(1));
    ASSERT_THAT(scene.instances(), SizeIs(2));
    EXPECT_GT(glm::determinant(scene.instances()[0].transform), 0.0);
    EXPECT_LT(glm::determinant(scene.instances()[1].transform), 0.0);
    // The pair spans -15..10 along x and 0..10 along y; x is turned to y, y to -x.
    expectBox(scene, {90, -15, 0}, {100, 10, 10});
    ASSERT_THAT(scene.nodes(), SizeIs(3));
    EXPECT_EQ(scene.nodes()[0].name, "pair");
    EXPECT_EQ(scene.nodes()[2].parent, 0U);
    EXPECT_EQ(scene.instances()[1].node, 2U);
}

TEST(Load3mf, takesColoursAsMaterials) {
    const std::string materials =
        "<basematerials id=\"7\"><base name=\"red\" displaycolor=\"#FF0000\"/><base name=\"half\" "
        "displaycolor=\"#80808080\"/></basematerials><m:colorgroup id=\"8\"><m:color "
        "color=\"#00FF00\"/></m:colorgroup>";
    const Scene based = sceneOf("<resources>" + materials + cube(1, "pid=\"7\" pindex=\"0\"", "pid=\"7\" p1=\"1\"") +
                                "</resources>" + buildOne);
    ASSERT_THAT(based.materials(), SizeIs(2));
    const std::vector<std::uint32_t>& of = based.meshes()[0].materials;
    ASSERT_THAT(of, SizeIs(12));
    EXPECT_EQ(based.materials()[of[0] - 1].name, "half");
    EXPECT_NEAR(based.materials()[of[0] - 1].color.r, 0.2159, 1e-3);  // 128 of 255 by sRGB
    EXPECT_NEAR(based.materials()[of[0] - 1].color.a, 128.0 / 255.0, 1e-6);
    EXPECT_EQ(based.materials()[of[2] - 1].name, "red");
    EXPECT_EQ(based.materials()[of[2] - 1].color, glm::vec4(1, 0, 0, 1));

    const Scene colored =
        sceneOf("<resources>" + materials + cube(1, "pid=\"8\" pindex=\"0\"") + "</resources>" + buildOne);
    ASSERT_THAT(colored.materials(), SizeIs(1));
    EXPECT_EQ(colored.materials()[0].color, glm::vec4(0, 1, 0, 1));
}

// As slicers write projects: each object in a file of its own.
TEST(Load3mf, followsTheProductionSpecificationIntoOtherFiles) {
    int ids = 0;
    const auto id = [&] { return fmt::format("p:UUID=\"{:08}-0000-4000-8000-000000000000\" ", ++ids); };
    const std::string root =
        model("<resources><object id=\"5\" type=\"model\" " + id() +
              "><components><component objectid=\"1\" p:path=\"/3D/Objects/one.model\" " + id() +
              " transform=\"1 0 0 0 1 0 0 0 1 20 0 0\"/></components></object></resources><build " + id() +
              "><item objectid=\"5\" " + id() + "/></build>");
    const Scene scene = sceneOf(
        archive(root, {{"3D/Objects/one.model", model("<resources>" + cube(1, id()) + "</resources><build/>")}}));
    expectBox(scene, {20, 0, 0}, {30, 10, 10});
}

TEST(Load3mf, saysWhatNoItemBuilds) {
    const Scene scene = sceneOf("<resources>" + cube(1) + cube(2) + "</resources>" + buildOne);
    EXPECT_THAT(scene.warnings(), ElementsAre("not drawn: 1 mesh that no item builds"));
    expectError(Error::Kind::Input, HasSubstr("1 mesh that no item builds"),
                [] { sceneOf("<resources>" + cube(1) + "</resources><build/>"); });
}

TEST(Load3mf, refusesWhatIsNoneInOneLine) {
    const std::vector<std::uint8_t> whole = oneCube();
    for (const std::size_t size : {whole.size() / 2, whole.size() - 30, std::size_t{40}})
        expectError(Error::Kind::Input, HasSubstr("part.3mf: expected"), [&] {
            sceneOf(std::vector<std::uint8_t>(whole.begin(), whole.begin() + static_cast<long>(size)));
        });
    const std::string text = "not an archive";
    expectError(Error::Kind::Input, HasSubstr("expected a ZIP archive in a 3MF file, found other text"),
                [&] { sceneOf(std::vector<std::uint8_t>(text.begin(), text.end())); });
    io::ZipWriter other;
    other.add("a.txt", {1, 2, 3});
    expectError(Error::Kind::Input,
                HasSubstr("expected [Content_Types].xml in a 3MF file, found a ZIP archive without it"),
                [&] { sceneOf(std::move(other).take()); });
    for (const std::string& inside :
         {std::string{"<resources>"}, "<resources>" + cube(1) + "</resources><build><item objectid=\"9\"/></build>",
          std::string{"<resources><object id=\"1\"><components><component objectid=\"1\"/></components></object>"
                      "</resources>"} +
              buildOne,
          std::string{"<resources><object id=\"1\"><mesh><vertices><vertex x=\"a\" y=\"0\" z=\"0\"/></vertices>"
                      "<triangles/></mesh></object></resources>"} +
              buildOne})
        expectError(Error::Kind::Input, HasSubstr("part.3mf: expected"), [&] { sceneOf(inside); });
}

TEST(Load3mf, saysWhatTheLibraryReadsOtherwiseThanTheFileSaysIt) {
    const Scene scene = sceneOf("<resources>" + cube(1) + "</resources>" + buildOne, "ell");
    EXPECT_THAT(scene.warnings(), ElementsAre("lib3mf: invalid model unit"));
}

// The unpacked size that the last file's entry in the archive's directory says.
std::vector<std::uint8_t> withSize(std::vector<std::uint8_t> bytes, std::uint32_t size) {
    const std::string entry{"PK\1\2"};
    const auto at = std::find_end(bytes.begin(), bytes.end(), entry.begin(), entry.end());
    for (std::ptrdiff_t i = 0; i < 4; ++i) at[24 + i] = static_cast<std::uint8_t>(size >> (8 * i));
    return bytes;
}

TEST(Load3mf, believesNoSizesThatAreNotTrue) {
    struct Lie {
        std::uint32_t size;
        std::string found;
    };
    for (const Lie& lie :
         std::vector<Lie>{{0, "expected 0 bytes in '3D/3dmodel.model' of a 3MF, found more"},
                          {1000, "expected 1000 bytes in '3D/3dmodel.model' of a 3MF, found more"},
                          {1'000'000'000, "expected 1000000000 bytes in '3D/3dmodel.model' of a 3MF, found "}})
        expectError(Error::Kind::Input, HasSubstr(lie.found), [&] { sceneOf(withSize(oneCube(), lie.size)); });
}

TEST(Load3mf, keepsToTheLimits) {
    LoadSettings settings;
    settings.limits.vertices = 43;  // 8 vertices and 36 indices
    expectError(Error::Kind::Input,
                HasSubstr("expected at most 43 vertices and indices, found more; raise max-vertices"),
                [&] { sceneOf(oneCube(), settings); });
    settings.limits = {};
    const auto pair = archive(model("<resources>" + cube(1) +
                                    "<object id=\"2\" type=\"model\"><components><component objectid=\"1\"/>"
                                    "<component objectid=\"1\"/></components></object></resources>"
                                    "<build><item objectid=\"2\"/></build>"));
    settings.limits.instances = 1;
    expectError(Error::Kind::Input, HasSubstr("expected at most 1 instances, found more; raise max-instances"),
                [&] { sceneOf(pair, settings); });
    settings.limits = {};
    settings.limits.nodes = 2;
    expectError(Error::Kind::Input, HasSubstr("expected at most 2 nodes, found more; raise max-nodes"),
                [&] { sceneOf(pair, settings); });
    settings.limits = {};
    std::string spaces(1'000'000, ' ');
    const auto padded = archive(model(spaces + "<resources>" + cube(1) + "</resources>" + buildOne));
    EXPECT_LT(padded.size(), 50'000U);
    settings.limits.fileSize = 500'000;
    expectError(Error::Kind::Input, HasSubstr("expected at most 500000 bytes in the files of a 3MF, found more"),
                [&] { sceneOf(padded, settings); });
}

#ifdef INKEDGE_3MF_LINES
TEST(Load3mf, hasTheSameLinesInAnyUnit) {
    const auto linesOf = [](const std::string& unit, double scale) {
        return linesToCompare(
            sceneOf(archive(model("<resources>" + cube(1) + "</resources><build><item objectid=\"1\" transform=\"" +
                                      fmt::format("{0:g} 0 0 0 {0:g} 0 0 0 {0:g} 0 0 0", scale) + "\"/></build>",
                                  unit))));
    };
    const Lines expected = linesOf("millimeter", 1.0);
    ASSERT_GT(expected.lines.size(), 3U);
    for (const auto& [unit, scale] : std::vector<std::pair<std::string, double>>{
             {"millimeter", 1e-6}, {"millimeter", 1e6}, {"micron", 1e-3}, {"inch", 1.0}, {"meter", 1e3}}) {
        SCOPED_TRACE(unit + " times " + fmt::format("{}", scale));
        expectSameLines(linesOf(unit, scale), expected, 1e-3);
    }
}
#endif

TEST(ZipDirectory, listsWhatIsPacked) {
    for (const std::uint64_t maxPlain : {std::uint64_t{0xFFFFFFFEU}, std::uint64_t{10}}) {  // the other one is ZIP64
        io::ZipWriter zip;
        zip.add("one", std::vector<std::uint8_t>(1000, 7));
        zip.add("folder/two", {});
        const std::vector<std::uint8_t> bytes = std::move(zip).take(maxPlain);
        const std::vector<ZipEntry> entries = zipDirectory(bytes);
        ASSERT_THAT(entries, SizeIs(2));
        EXPECT_EQ(entries[0].name, "one");
        EXPECT_EQ(entries[0].size, 1000U);
        EXPECT_EQ(entries[1].name, "folder/two");
        EXPECT_EQ(entries[1].size, 0U);
        for (std::size_t size = 0; size < bytes.size(); ++size)
            expectError(Error::Kind::Input, HasSubstr("of a ZIP archive"),
                        [&] { static_cast<void>(zipDirectory(std::span{bytes}.first(size))); });
    }
}

}  // namespace
}  // namespace inkedge::cad

// inkedge render with lines from object space, and lines as files.
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/decode_png.h"
#include "io/well_formed.h"

namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

class RenderLines : public Command {
protected:
    /// inkedge render ASSET -o OUTPUT, 64 x 48, and these.
    Outcome draw(const std::string& model, const std::string& output, const Arguments& more = {},
                 const Environment& environment = {}) const {
        Arguments arguments{"render", asset(model), "-o", output};
        if (std::ranges::find(more, "--size") == more.end()) arguments.insert(arguments.end(), {"--size", "64x48"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments, environment);
    }

    std::string text(const std::string& name) const { return contents(folder_ / name); }
    json lines(const std::string& name) const { return json::parse(text(name)); }

    /// An SVG without its title and metadata.
    std::string drawing(const std::string& name) const {
        const std::string all = text(name);
        expectWellFormed(all);
        return all.substr(std::min(all.find("</metadata>"), all.size()));
    }
};

const Arguments seesNothing{"--lines-from",      "object", "--hidden",           "solid",
                            "--camera-position", "0,0,9",  "--camera-direction", "0,0,1"};

std::vector<std::string> keysOf(const json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

std::set<std::string> typesOf(const json& drawing) {
    std::set<std::string> types;
    for (const json& line : drawing.at("lines")) types.insert(line.at("type"));
    return types;
}

/// The length of all lines in the picture, pixels.
double lengthOf(const json& drawing) {
    double length = 0.0;
    for (const json& line : drawing.at("lines")) {
        const json& pixels = line.at("pixels");
        for (std::size_t i = line.at("closed") ? 0 : 1; i < pixels.size(); ++i) {
            const json& from = pixels.at(i > 0 ? i - 1 : pixels.size() - 1);
            length += std::hypot(pixels.at(i).at(0).get<double>() - from.at(0).get<double>(),
                                 pixels.at(i).at(1).get<double>() - from.at(1).get<double>());
        }
    }
    return length;
}

std::array<double, 4> multiplied(const json& rows, const std::array<double, 4>& column) {
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) result[i] += rows.at(i).at(k).get<double>() * column[k];
    }
    return result;
}

// Two boxes that lie in each other, with tops, bottoms, fronts and backs in common, behind a screen of six by four.
std::string boxesBehindAScreen() {
    std::string obj = "o screen\nv -3 -2 3\nv 3 -2 3\nv 3 2 3\nv -3 2 3\nf 1 2 3 4\n";
    int first = 5;
    for (const auto& [left, right] : {std::pair{-2.0, 0.0}, std::pair{-1.3, 2.0}}) {
        obj += fmt::format("o box{}\n", first);
        for (int i = 0; i < 8; ++i)
            obj += fmt::format("v {} {} {}\n", (i & 1) != 0 ? right : left, (i & 2) - 1, (i & 4) / 4);
        for (const std::array<int, 4>& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                               std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
            obj += fmt::format("f {} {} {} {}\n", first + face[0], first + face[1], first + face[2], first + face[3]);
        first += 8;
    }
    return obj;
}

// The length of the paths of an SVG that are made of relative moves, lines and closings alone.
double lengthOfPaths(const std::string& svg) {
    static const std::regex path{R"-( d="([^"]*)")-"};
    static const std::regex token{R"([mlz]|-?(?:\d+\.?\d*|\.\d+))"};
    double length = 0.0;
    for (std::sregex_iterator p{svg.begin(), svg.end(), path}; p != std::sregex_iterator{}; ++p) {
        const std::string data = (*p)[1];
        bool moves = false;
        std::array<double, 2> fromStart{};
        std::vector<double> step;
        for (std::sregex_iterator t{data.begin(), data.end(), token}; t != std::sregex_iterator{}; ++t) {
            if (t->str() == "z") length += std::hypot(fromStart[0], fromStart[1]);
            if (t->str() == "m") moves = true;
            if (t->str() == "m" || t->str() == "l" || t->str() == "z") continue;
            step.push_back(std::stod(t->str()));
            if (step.size() < 2) continue;
            length += moves ? 0.0 : std::hypot(step[0], step[1]);
            fromStart = moves ? std::array{0.0, 0.0} : std::array{fromStart[0] + step[0], fromStart[1] + step[1]};
            moves = false;
            step.clear();
        }
    }
    return length;
}

TEST_F(RenderLines, OfLinesThatFallOnEachOtherSvgAndPngHoldOne) {
    const std::string model = file("boxes.obj", boxesBehindAScreen());
    constexpr int pixels = 30;  // a unit
    for (const std::string which : {"merge", "keep"}) {
        for (const std::string extension : {".json", ".svg", ".png"}) {
            expectSuccess(run({"render",
                               model,
                               "-o",
                               which + extension,
                               "--coincident",
                               which,
                               "--hidden",
                               "dashed",
                               "--lines-from",
                               "object",
                               "--camera-orthographic",
                               "5",
                               "--azimuth",
                               "0",
                               "--elevation",
                               "0",
                               "--size",
                               "210x150",
                               "--line-width",
                               "2"}));
        }
    }
    const double right = pixels * (20.0 + 2.0 * 4.0 + 4.0 * 2.0);  // the screen, the rows, the uprights
    EXPECT_NEAR(lengthOf(lines("merge.json")), right, 1.0);
    EXPECT_NEAR(lengthOfPaths(drawing("merge.svg")), right, 1.0);
    EXPECT_GT(lengthOfPaths(drawing("keep.svg")), 1.3 * right);
    // Along the top of both boxes, where they lie in each other: dashes of six pixels and two half caps, gaps of three.
    const auto inked = [&](const std::string& png) {
        const Picture picture = decodePng(text(png));
        const std::size_t row = picture.width * (75 - pixels);
        const std::string_view overlap = std::string_view{picture.grey}.substr(row + 105 - 39, 39);
        const auto dark =
            std::ranges::count_if(overlap, [](char level) { return static_cast<unsigned char>(level) < 192; });
        return static_cast<double>(dark) / 39.0;
    };
    EXPECT_LT(inked("merge.png"), 0.85);
    EXPECT_GT(inked("keep.png"), 0.9) << "the test sees no gaps that are filled";
}

TEST_F(RenderLines, SvgHasAGroupATypeAndVisibility) {
    const Outcome outcome = draw("cube.glb", "cube.svg", {"--hidden", "dashed", "--line-width", "2"});
    expectSuccess(outcome);
    EXPECT_EQ(outcome.out + outcome.error, "");
    EXPECT_THAT(folder_.names(), ElementsAre("cube.svg"));
    EXPECT_THAT(text("cube.svg"), AllOf(HasSubstr(R"(width="64" height="48" viewBox="0 0 64 48")"),
                                        HasSubstr("<title>cube.svg</title>")));
    const std::string groups = drawing("cube.svg");
    const auto layerOf = [](const std::string& name) {
        return name + R"(" inkscape:groupmode="layer" inkscape:label=")" + name + '"';
    };
    const std::vector<std::size_t> offsets{
        groups.find(layerOf("crease-hidden") + R"( stroke="#000000" stroke-width="1" stroke-dasharray="6 4">)"),
        groups.find(layerOf("crease-visible") + R"( stroke="#000000" stroke-width="2">)"),
        groups.find(layerOf("outline-visible") + R"( stroke="#000000" stroke-width="2">)")};
    EXPECT_THAT(offsets, Each(testing::Lt(groups.size()))) << groups;
    EXPECT_TRUE(std::ranges::is_sorted(offsets)) << "what covers last";
    EXPECT_THAT(groups, HasSubstr(R"(data-object="1")"));
}

TEST_F(RenderLines, SvgFillsAPageOfPaper) {
    expectSuccess(draw("cube.glb", "page.svg", {"--page-size", "A5-landscape", "--line-width", "0.5mm"}));
    EXPECT_THAT(text("page.svg"), HasSubstr(R"(width="210mm" height="148mm")"));
    expectWellFormed(text("page.svg"));
}

TEST_F(RenderLines, JsonIsWhatTheReadmeSays) {
    expectSuccess(draw("teapot.glb", "teapot.json", {"--hidden", "solid"}));
    EXPECT_THAT(folder_.names(), ElementsAre("teapot.json"));
    const json all = lines("teapot.json");
    EXPECT_THAT(keysOf(all), UnorderedElementsAre("format", "version", "units", "size", "camera", "bounds", "source",
                                                  "instances", "materials", "tolerance", "settings", "lines"));
    EXPECT_EQ(all.at("format"), "inkedge lines");
    EXPECT_EQ(all.at("version"), 3);
    EXPECT_EQ(all.at("size"), json({64, 48}));
    EXPECT_EQ(all.at("settings").at("hidden"), "solid");
    ASSERT_GT(all.at("lines").size(), 10U);
    std::set<bool> visible;
    std::set<int> objects;
    std::set<int> ids;
    for (const json& line : all.at("lines")) {
        ASSERT_THAT(keysOf(line),
                    UnorderedElementsAre("id", "type", "visible", "closed", "object", "patch", "pixels", "positions"));
        visible.insert(line.at("visible").get<bool>());
        objects.insert(line.at("object").get<int>());
        ids.insert(line.at("id").get<int>());
        EXPECT_GE(line.at("patch"), 1);
        ASSERT_EQ(line.at("pixels").size(), line.at("positions").size());
        ASSERT_GE(line.at("pixels").size(), 2U);
    }
    EXPECT_EQ(visible, (std::set<bool>{false, true}));
    EXPECT_EQ(objects, (std::set<int>{1, 2, 3, 4})) << "its four nodes";
    EXPECT_EQ(ids.size(), all.at("lines").size());
    EXPECT_EQ(all.at("source").at("name"), "teapot.glb");
    EXPECT_EQ(all.at("source").at("unit"), "metre");
    EXPECT_EQ(all.at("source").at("triangles"), 5340);
    EXPECT_EQ(all.at("source").at("contour_finder"), "every");
    std::set<std::string> names;
    for (const json& instance : all.at("instances")) names.insert(instance.at("node").get<std::string>());
    EXPECT_EQ(names, (std::set<std::string>{"teapot/body", "teapot/handle", "teapot/lid", "teapot/spout"}));
    EXPECT_EQ(all.at("tolerance"), 0.25);
}

TEST_F(RenderLines, JsonPixelsArePointsAsItsCameraSeesThem) {
    for (const Arguments& view : {Arguments{}, Arguments{"--camera-orthographic", "0"}}) {
        expectSuccess(draw("teapot.glb", "teapot.json", view));
        const json all = lines("teapot.json");
        for (const json& line : all.at("lines")) {
            for (std::size_t i = 0; i < line.at("pixels").size(); ++i) {
                const json& point = line.at("positions").at(i);
                const auto eye = multiplied(all.at("camera").at("view"), {point.at(0), point.at(1), point.at(2), 1.0});
                const auto clip = multiplied(all.at("camera").at("projection"), eye);
                // Places are rounded to 0.001 pixel, points to a millionth of a model that is some 60 pixels wide.
                ASSERT_NEAR((clip[0] / clip[3] + 1.0) / 2.0 * 64, line.at("pixels").at(i).at(0).get<double>(), 0.001);
                ASSERT_NEAR((1.0 - clip[1] / clip[3]) / 2.0 * 48, line.at("pixels").at(i).at(1).get<double>(), 0.001);
            }
        }
    }
}

// Those that meet in the corner away from the eye.
TEST_F(RenderLines, HiddenOnesOfACubeAreItsThreeEdgesBehind) {
    expectSuccess(draw("cube.glb", "cube.json", {"--hidden", "dashed"}));
    const json all = lines("cube.json");
    const json& eye = all.at("camera").at("eye");
    std::map<std::size_t, double> lengths;  // by axis
    for (const json& line : all.at("lines")) {
        const json& points = line.at("positions");
        for (std::size_t i = 1; i < points.size() && !line.at("visible"); ++i) {
            int along = -1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double from = points.at(i - 1).at(axis);
                const double to = points.at(i).at(axis);
                if (from != to) {
                    EXPECT_EQ(along, -1) << "not along an axis: " << line;
                    along = static_cast<int>(axis);
                    lengths[axis] += std::abs(to - from);
                } else {
                    EXPECT_NEAR(to, eye.at(axis) > 0.0 ? -0.5 : 0.5, 1e-6) << line;
                }
            }
        }
    }
    EXPECT_EQ(lengths.size(), 3U);
    for (const auto& [axis, length] : lengths) EXPECT_NEAR(length, 1.0, 1e-5) << axis;
    expectSuccess(draw("cube.glb", "seen.json"));
    const json seen = lines("seen.json");
    EXPECT_GT(lengthOf(seen), 0.0);
    for (const json& line : seen.at("lines")) EXPECT_EQ(line.at("visible"), true);
}

TEST_F(RenderLines, AreDrawnFromSeveralViews) {
    expectSuccess(draw("gear.glb", "{view}.svg", {"--views", "turntable:3", "--elevation", "10"}));
    EXPECT_THAT(folder_.names(), ElementsAre("000.svg", "001.svg", "002.svg"));
    EXPECT_NE(drawing("000.svg"), drawing("001.svg"));
    expectSuccess(draw("gear.glb", "one.svg", {"--azimuth", "120", "--elevation", "10"}));
    EXPECT_EQ(drawing("001.svg"), drawing("one.svg"));
}

TEST_F(RenderLines, FillTheFieldsOfTheOutputsName) {
    expectSuccess(draw("cube.glb", "{model}-{view}-{map}.svg"));
    EXPECT_THAT(folder_.names(), ElementsAre("cube-0-outline.svg"));
}

TEST_F(RenderLines, HaveNoMapsInAFileOfLines) {
    for (const std::string output : {"x.svg", "x.json", "{map}.SVG"}) {
        expectFailure(draw("cube.glb", output, {"--maps", "depth"}), 2,
                      HasSubstr("--maps: expected a picture as --output, found " + output + ", which holds lines"));
    }
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(RenderLines, FromObjectSpaceLeaveTheMapsAsTheyAre) {
    expectSuccess(draw("gear.glb", "image.png", {"--maps", "types,depth,ids"}));
    expectSuccess(draw("gear.glb", "object.png", {"--maps", "types,depth,ids", "--lines-from", "object"}));
    for (const char* map : {".types.png", ".depth.png", ".ids-patch.png", ".ids-object.png"}) {
        EXPECT_GT(text(std::string{"image"} + map).size(), 100U) << map;
        EXPECT_EQ(text(std::string{"image"} + map), text(std::string{"object"} + map)) << map;
    }
    EXPECT_NE(text("image.png"), text("object.png"));
}

TEST_F(RenderLines, OfACameraThatSeesNothingAreAnEmptyDrawing) {
    for (const char* output : {"none.svg", "none.json", "none.png"}) {
        const Outcome outcome = draw("cube.glb", output, seesNothing);
        expectSuccess(outcome);
        EXPECT_EQ(outcome.error, "");
    }
    EXPECT_THAT(drawing("none.svg"), AllOf(Not(HasSubstr("<g")), Not(HasSubstr("<path"))));
    EXPECT_EQ(lines("none.json").at("lines"), json::array());
    EXPECT_EQ(decodePng(text("none.png")).grey, std::string(64 * 48, '\xff'));
}

TEST_F(RenderLines, ByTheGaussMapNeedAnOrthographicCamera) {
    for (const char* output : {"gauss.svg", "gauss.json", "gauss.png"}) {
        expectFailure(draw("gear.glb", output, {"--contour-finder", "gauss", "--lines-from", "object"}), 2,
                      HasSubstr("--contour-finder: expected an orthographic camera for gauss"));
    }
    EXPECT_THAT(folder_.names(), IsEmpty());
    expectSuccess(draw("gear.glb", "gauss.svg", {"--camera-orthographic", "0", "--contour-finder", "gauss"}));
    expectSuccess(draw("gear.glb", "every.svg", {"--camera-orthographic", "0"}));
    EXPECT_EQ(drawing("gauss.svg"), drawing("every.svg"));
}

TEST_F(RenderLines, FromImageSpaceAreFilesToo) {
    expectSuccess(draw("cube.glb", "image.svg", {"--lines-from", "image"}));
    EXPECT_THAT(drawing("image.svg"), AllOf(HasSubstr("<g class=\"inkedge outline visible "), HasSubstr("<path")));
    expectSuccess(draw("cube.glb", "image.json", {"--lines-from", "image", "--size", "256x256"}));
    expectSuccess(draw("cube.glb", "object.json", {"--size", "256x256"}));
    EXPECT_EQ(typesOf(lines("image.json")), (std::set<std::string>{"outline", "crease"}));
    // Three ends of the inner edges, and the corners, are found up to a pixel off: of 1200 pixels.
    EXPECT_NEAR(lengthOf(lines("image.json")) / lengthOf(lines("object.json")), 1.0, 0.01);
    expectFailure(draw("cube.glb", "classic.svg", {"--lines-from", "image", "--detector", "classic"}), 2,
                  HasSubstr("lines from image: expected the planes detector, found"));
}

TEST_F(RenderLines, AreDescribedInMetadataAndJson) {
    const Outcome outcome = draw("cube.glb", "cube.svg", {"--metadata", "m.json", "--json"});
    expectSuccess(outcome);
    const json printed = json::parse(outcome.out);
    EXPECT_EQ(printed.at("files"), json{"cube.svg"});
    const json metadata = json::parse(text("m.json"));
    EXPECT_EQ(printed.at("camera"), metadata.at("camera"));
    EXPECT_EQ(metadata.at("size"), json({64, 48}));
    EXPECT_EQ(metadata.at("triangles"), 12);
    for (const char* stage : {"load", "prepare", "prepare lines", "visibility", "write"}) {
        EXPECT_GE(metadata.at("milliseconds").value(stage, -1.0), 0.0) << stage;
    }
    EXPECT_FALSE(metadata.at("milliseconds").contains("context"));
    EXPECT_EQ(metadata.at("backend"), nullptr);
    expectSuccess(draw("cube.glb", "cube.png", {"--metadata", "picture.json"}));
    const json picture = json::parse(text("picture.json"));
    for (const char* key : {"camera", "size", "bounds"}) EXPECT_EQ(metadata.at(key), picture.at(key)) << key;
}

TEST_F(RenderLines, NeedNoOpenGl) {
    for (const char* output : {"cube.svg", "cube.json", "cube.png"}) {
        expectSuccess(draw("cube.glb", output, {"--lines-from", "object"}));
        const std::string expected = text(output);
        std::filesystem::remove(folder_ / output);
        const Outcome outcome = draw("cube.glb", output, {"--lines-from", "object", "-v"}, withoutBackends());
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        EXPECT_THAT(outcome.error, HasSubstr("drawn without OpenGL"));
        EXPECT_EQ(text(output), expected) << output;
    }
    expectSuccess(draw("cube.glb", "{view}.svg", {"--views", "turntable:9"}, withoutBackends()));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "008.svg"));
    const auto none = HasSubstr("expected a context for offscreen OpenGL 4.5, found none");
    expectFailure(draw("cube.glb", "cube.svg", {"--lines-from", "image"}, withoutBackends()), 4, none);
    expectFailure(draw("cube.glb", "cube.png", {"--lines-from", "object", "--maps", "ids"}, withoutBackends()), 4,
                  none);
}

// A shared library that every process of a C++ program has open.
std::filesystem::path someLibrary() {
    std::ifstream maps{"/proc/self/maps"};
    for (std::string line; std::getline(maps, line);) {
        if (line.find("libstdc++.so") != std::string::npos) return line.substr(line.find('/'));
    }
    return {};
}

TEST_F(RenderLines, NameEmbreeWhereItIsDamagedOrAnotherLibrary) {
    const Environment here{{"LD_LIBRARY_PATH", (folder_ / "any").parent_path().string()}};  // looked through first
    const std::string number = std::to_string(INKEDGE_EMBREE_VERSION);
    const std::string library = "libembree" + number + ".so." + number;
    put(folder_ / library, "no library");
    expectFailure(
        draw("cube.glb", "cube.svg", {}, here), 1,
        AllOf(HasSubstr("lines from object space: "), HasSubstr("inkedge_embree.so that can be opened, found: "),
              HasSubstr(library + ": file too short; install Embree or reinstall inkedge, or use "
                                  "--lines-from image")));
    expectSuccess(draw("cube.glb", "cube.svg", {"--lines-from", "image"}, here));
    const Outcome without = draw("primitives.glb", "p.png", {}, here);
    EXPECT_EQ(without.exitCode, 0);
    EXPECT_THAT(without.error, HasSubstr("primitives.glb: marked lines are not drawn: lines from object space: "));
    EXPECT_THAT(draw("cube.glb", "cube.png", {}, here).error, testing::IsEmpty());
    std::filesystem::remove(folder_ / library);
    if (someLibrary().empty()) GTEST_SKIP() << "SKIPPED: no /proc";
    std::filesystem::create_symlink(someLibrary(), folder_ / library);
    expectFailure(draw("cube.glb", "other.svg", {}, here), 1,
                  AllOf(HasSubstr("lines from object space: "), HasSubstr("undefined symbol: rtc"),
                        HasSubstr("; install Embree or reinstall inkedge, or use --lines-from image")));
}

TEST_F(RenderLines, VerboseNamesTheBackendStagesAndFile) {
    const Outcome outcome = draw("cube.glb", "cube.svg", {"-v", "--metadata", "m.json", "--lines-from", "image"});
    expectSuccess(outcome);
    const json backend = json::parse(text("m.json")).at("backend");
    for (const char* part : {"backend", "platform", "renderer", "version"}) {
        EXPECT_FALSE(backend.at(part).get<std::string>().empty()) << part;
        EXPECT_THAT(outcome.error, HasSubstr(backend.at(part).get<std::string>())) << part;
    }
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("load"), HasSubstr("write"), HasSubstr("wrote cube.svg")));
}

TEST_F(RenderLines, ToStandardOutputArePng) {
    expectSuccess(draw("cube.glb", "cube.png", {"--lines-from", "object"}));
    const Outcome outcome = draw("cube.glb", "-", {"--lines-from", "object"});
    expectSuccess(outcome);
    EXPECT_EQ(outcome.out, text("cube.png"));
    EXPECT_EQ(decodePng(outcome.out).width, 64U);
}

TEST_F(RenderLines, NeedAFolder) {
    put(folder_ / "file", "");
    for (const std::string output : {"missing/cube.svg", "missing/cube.json", "file/cube.svg"}) {
        expectFailure(draw("cube.glb", output), 5, HasSubstr(output + ": cannot be written: expected a folder"));
    }
    EXPECT_THAT(folder_.names(), ElementsAre("file"));
}

// The ends of what the settings allow: a picture, an empty one maybe, or a line that says what is too much.
TEST_F(RenderLines, OfExtremeCamerasAreDrawnOrRefused) {
    for (const std::string from : {"image", "object"}) {
        for (const Arguments& camera :
             {Arguments{"--eye", "1e6,1e6,0"}, Arguments{"--fov", "0.001"}, Arguments{"--fov", "179"},
              Arguments{"--fov", "0.001", "--zoom", "1e6"}, Arguments{"--zoom", "1e6"}, Arguments{"--zoom", "0.001"},
              Arguments{"--camera-orthographic", "1e-8"}, Arguments{"--camera-orthographic", "1e36"},
              Arguments{"--eye", "1e6,0,0", "--target", "-1e30,0,0"}, Arguments{"--eye", "1e-30,0,0"}}) {
            Arguments flags{"--lines-from", from, "--hidden", "dashed"};
            flags.insert(flags.end(), camera.begin(), camera.end());
            const Outcome outcome = draw("bracket.glb", "a.svg", flags);
            if (outcome.exitCode != 0) expectFailure(outcome, 2, HasSubstr("expected "));
        }
    }
}

}  // namespace

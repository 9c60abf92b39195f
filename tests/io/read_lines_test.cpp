#include <inkedge/read_lines.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "curves/curves.h"

namespace inkedge::io {
namespace {

using curves::closedThrough;
using curves::lineThrough;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

Camera camera(double orthographicHeight = 0.0) {
    Camera camera;
    camera.view[3] = {0.1, -1.0 / 3.0, -5.0, 1.0};
    camera.orthographicHeight = orthographicHeight;
    camera.near = 1.0 / 7.0;
    camera.far = 9.0;
    return camera;
}

Lines sample() {
    Lines lines;
    lines.size = {200, 100};
    lines.camera = camera();
    lines.bounds = {{1.0 / 3.0, 2, 3}, 1.7};
    lines.source = {.name = "part \"a\".glb",
                    .format = "glTF 2.0",
                    .unit = LengthUnit::Millimetre,
                    .triangles = 12,
                    .warnings = {"one", "two"}};
    glm::dmat4 moved{1.0};
    moved[3] = {0.1, 2.0, -1.0 / 3.0, 1.0};
    lines.names = {{{1, "crane/bolt", "bolt", {1, 3}, glm::dmat4{1.0}}, {7, "näme <&>", "", {}, moved}},
                   {"tin", "", "glass \"x\""}};
    Line line = closedThrough({{10.12345, 20}, {500, -30}, {40, 60}});
    line.type = LineType::Occlusion;
    line.id = 4;
    line.object = 7;
    line.patch = 17;
    Line hidden = lineThrough({{1, 2}, {3, 4}});
    hidden.visible = false;
    hidden.id = 9;
    hidden.object = 1;
    hidden.width = 0.375;
    lines.lines = {line, hidden};
    return lines;
}

Settings allOfThem(double simplify = 0.0) {
    Settings settings;
    settings.lines.hidden = HiddenLines::Solid;
    settings.lines.simplify = simplify;
    return settings;
}

std::string writtenAgain(const std::string& text, const Settings& settings) {
    return linesJson(linesFromJson(text), settings);
}

TEST(ReadLines, givesBackWhatWasWritten) {
    const Lines lines = sample();
    const Lines read = linesFromJson(linesJson(lines, allOfThem()));
    EXPECT_EQ(read.size, lines.size);
    EXPECT_EQ(read.camera.view, lines.camera.view);
    EXPECT_EQ(read.camera.viewAngle, lines.camera.viewAngle);
    EXPECT_FALSE(read.camera.orthographic());
    EXPECT_EQ(read.camera.near, lines.camera.near);
    EXPECT_EQ(read.camera.far, lines.camera.far);
    EXPECT_EQ(read.bounds.centre, lines.bounds.centre);
    EXPECT_EQ(read.bounds.radius, lines.bounds.radius);
    EXPECT_EQ(read.source.name, lines.source.name);
    EXPECT_EQ(read.source.format, lines.source.format);
    EXPECT_EQ(read.source.unit, LengthUnit::Millimetre);
    EXPECT_EQ(read.source.triangles, 12U);
    EXPECT_EQ(read.source.warnings, lines.source.warnings);
    EXPECT_EQ(read.source.space, LinesFrom::Object);
    EXPECT_EQ(read.names, lines.names);
    EXPECT_EQ(read.tolerance, 0.0);
    EXPECT_EQ(read.backend.backend, "");
    EXPECT_TRUE(read.times.empty());
    ASSERT_EQ(read.lines.size(), 2U);
    const Line& line = read.lines[0];
    EXPECT_EQ(line.type, LineType::Occlusion);
    EXPECT_TRUE(line.visible);
    EXPECT_TRUE(line.closed);
    EXPECT_EQ(line.id, 4U);
    EXPECT_EQ(line.object, 7U);
    EXPECT_EQ(line.patch, 17U);
    ASSERT_EQ(line.points.size(), 3U);
    EXPECT_EQ(line.points[0].pixel, glm::dvec2(10.123, 20));
    EXPECT_EQ(line.points[2].position, glm::dvec3(2, 40, 60));
    EXPECT_FALSE(read.lines[1].visible);
    EXPECT_FALSE(read.lines[1].closed);
    EXPECT_EQ(line.width, 1.0);
    EXPECT_EQ(read.lines[1].width, 0.375);
}

TEST(ReadLines, haveEveryType) {
    Settings settings = allOfThem(0.0);
    settings.picture.lines = allLineTypes;
    for (const LineType type : allLineTypes) {
        Lines lines = sample();
        lines.lines[0].type = type;
        EXPECT_EQ(linesFromJson(linesJson(lines, settings)).lines.at(0).type, type) << name(type);
    }
}

TEST(ReadLines, haveTheStrengthsOfLinesOfForm) {
    Lines lines = sample();
    lines.lines[0].type = LineType::Ridge;
    lines.lines[0].points[1].strength = 0.25;
    Settings settings = allOfThem(0.0);
    settings.picture.lines = allLineTypes;
    const std::string text = linesJson(lines, settings);
    EXPECT_EQ(linesFromJson(text).lines.at(0).points[0].strength, 1.0);
    EXPECT_EQ(linesFromJson(text).lines.at(0).points[1].strength, 0.25);
    const std::string strengths = "\"strengths\":[1,0.25,";
    ASSERT_THAT(text, HasSubstr(strengths));
    const auto expectRefusal = [&](const std::string& instead, std::string_view message) {
        std::string changed = text;
        changed.replace(changed.find(strengths), strengths.size(), instead);
        expectError(Error::Kind::Input, HasSubstr(message), [&] { (void)linesFromJson(changed); });
    };
    expectRefusal("\"strengths\":[1,1.25,", "lines[0].strengths: expected numbers from 0 to 1, found '1.25'");
    expectRefusal("\"strengths\":[", "lines[0].strengths: expected a list of 3, as pixels is");
    expectRefusal("\"other\":[1,0.25,", "lines[0].strengths: expected a list");
}

TEST(ReadLines, knowsWhatFoundThem) {
    Lines lines = sample();
    lines.camera = camera(3.5);
    lines.source.finder = ContourFinder::Gauss;
    EXPECT_EQ(linesFromJson(linesJson(lines, {})).source.finder, ContourFinder::Gauss);
    EXPECT_EQ(linesFromJson(linesJson(lines, {})).camera.orthographicHeight, 3.5);
    lines.source.space = LinesFrom::Image;
    lines.source.detector = Detector::SaitoTakahashi;
    EXPECT_EQ(linesFromJson(linesJson(lines, {})).source.space, LinesFrom::Image);
    EXPECT_EQ(linesFromJson(linesJson(lines, {})).source.detector, Detector::SaitoTakahashi);
}

// Simplifying what was simplified takes more points off, and rounding what was rounded may move them.
TEST(ReadLines, areWrittenAgainByteForByte) {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> exponent{-12.0, 20.0};
    for (const double radius : {1.7, 0.0, 5e-320, 1e-9, 3e17, 1e200, 1e308}) {
        Lines lines = sample();
        lines.bounds.radius = radius;
        for (unsigned seed = 0; seed < 20; ++seed) {
            Line line = curves::winding(400, 0.7, seed);
            for (LinePoint& p : line.points) p.position = p.position * std::pow(10.0, exponent(random));
            if (seed % 4 == 0)
                for (LinePoint& p : line.points) p.pixel = p.pixel * std::pow(10.0, exponent(random));
            line.points[7].position = {-0.0, 1e308, -1e-308};
            lines.lines.push_back(line);
        }
        for (const double simplify : {0.0, 0.1, 0.25, 3.0, 100.0}) {
            const std::string text = linesJson(lines, allOfThem(simplify));
            EXPECT_EQ(writtenAgain(text, allOfThem(simplify)), text) << radius << ", " << simplify;
            const std::string coarser = writtenAgain(text, allOfThem(simplify + 0.5));
            EXPECT_EQ(writtenAgain(coarser, allOfThem(simplify + 0.5)), coarser);
        }
    }
}

TEST(ReadLines, simplifiesByNoMoreThanWhatIsLeftOfTheTolerance) {
    Lines lines = sample();
    lines.lines = {curves::winding(2000, 0.3, 5)};
    const Lines read = linesFromJson(linesJson(lines, allOfThem(0.25)));
    EXPECT_EQ(read.tolerance, 0.25);
    EXPECT_LT(read.lines[0].points.size(), 1000U);
    const auto pointsAfter = [&](double simplify) {
        return linesFromJson(linesJson(read, allOfThem(simplify))).lines[0].points.size();
    };
    EXPECT_EQ(pointsAfter(0.1), read.lines[0].points.size());
    EXPECT_EQ(pointsAfter(0.25), read.lines[0].points.size());
    EXPECT_LT(pointsAfter(2.0), read.lines[0].points.size());
    EXPECT_EQ(linesSvg(read, allOfThem(0.25)),
              linesSvg(read, allOfThem(0.2))
                  .replace(linesSvg(read, allOfThem(0.2)).find("\"simplify\":\"0.2\""), 16, "\"simplify\":\"0.25\""));
}

TEST(LinesJson, leavesOutPointsThatAreNotFinite) {
    for (const double wrong : {infinity, -infinity, std::nan("")}) {
        Lines lines = sample();
        lines.lines[0].points[1].pixel.y = wrong;
        lines.lines[1].points[0].position.z = wrong;
        for (const double simplify : {0.0, 0.25}) {
            const std::string text = linesJson(lines, allOfThem(simplify));
            const json all = json::parse(text);
            ASSERT_EQ(all.at("lines").size(), 1U) << "a line of one point is none";
            EXPECT_EQ(all.at("lines").at(0).at("pixels").size(), 2U);
            EXPECT_EQ(writtenAgain(text, allOfThem(simplify)), text);
        }
    }
}

TEST(LinesJson, isRefusedWhereCameraOrBoundsAreNotFinite) {
    const auto refuses = [](auto change) {
        Lines lines = sample();
        change(lines);
        expectError(Error::Kind::Usage, HasSubstr("expected a camera, bounds and a tolerance that are finite"),
                    [&] { (void)linesJson(lines, {}); });
    };
    refuses([](Lines& lines) { lines.camera = {}; });  // near is far
    refuses([](Lines& lines) { lines.camera.view = glm::dmat4{0.0}; });
    refuses([](Lines& lines) { lines.bounds.centre.x = infinity; });
    refuses([](Lines& lines) { lines.bounds.radius = std::nan(""); });
    refuses([](Lines& lines) { lines.tolerance = infinity; });
}

std::string refusal(const std::string& text) {
    try {
        (void)linesFromJson(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_THAT(error.what(), AllOf(HasSubstr("expected"), HasSubstr("found"), Not(HasSubstr("\n"))));
        return error.what();
    }
    return "none";
}

json valid() { return json::parse(linesJson(sample(), allOfThem())); }

std::string refusalWith(const std::string& pointer, const json& value) {
    json all = valid();
    all[json::json_pointer{pointer}] = value;
    return refusal(all.dump());
}

TEST(ReadLines, refuseWhatIsNoJsonOfOurs) {
    EXPECT_THAT(refusal(""), StartsWith("expected JSON, found something else at byte "));
    EXPECT_THAT(refusal("<svg/>"), StartsWith("expected JSON, found something else at byte 1"));
    EXPECT_THAT(refusal(valid().dump().substr(0, 700)), StartsWith("expected JSON, found something else at byte "));
    EXPECT_THAT(refusal("{\"format\": \"\xff\"}"), StartsWith("expected JSON, found something else at byte "));
    EXPECT_THAT(refusal("{\"format\": 1e999}"), HasSubstr("expected numbers that a double holds, found another"));
    EXPECT_THAT(refusal("{\"format\": NaN}"), StartsWith("expected JSON, found something else at byte "));
    EXPECT_THAT(refusal("{\"a\": 1, \"a\": 2}"), HasSubstr("expected each key once, found 'a' again"));
    for (const char* text : {"null", "3", "\"x\"", "[]"})
        EXPECT_THAT(refusal(text), StartsWith("lines: expected an object, found ")) << text;
    EXPECT_EQ(refusal("{}"), "format: expected \"inkedge lines\", found none");
    EXPECT_THAT(refusal(R"({"format": "inkedge lines", "version": 1, "lines": [{"places": []}]})"),
                StartsWith("version: "));
    EXPECT_EQ(refusal(R"({"lines": []})"), "format: expected \"inkedge lines\", found none");
    for (const json& width : {json(0), json(-1), json(1.5)})
        EXPECT_THAT(refusalWith("/lines/1/width", width),
                    StartsWith("lines[1].width: expected a number over 0 and at most 1, found "));
    EXPECT_EQ(refusalWith("/version", 1), "version: expected 3; find the lines again, found '1'");
    EXPECT_EQ(refusalWith("/format", "other"), "format: expected \"inkedge lines\", found 'other'");
}

TEST(ReadLines, refuseEachValueThatIsMissingOrOfAnotherType) {
    const json all = valid();
    std::vector<std::string> pointers;
    for (const char* parent : {"", "/camera", "/bounds", "/source", "/instances/0", "/materials/0", "/lines/0"}) {
        for (const auto& [key, value] : all.at(json::json_pointer{parent}).items())
            pointers.push_back(fmt::format("{}/{}", parent, key));
    }
    int looked = 0;
    for (const std::string& pointer : pointers) {
        const std::string key = pointer.substr(pointer.rfind('/') + 1);
        if (key == "units" || key == "settings" || key == "projection" || key == "eye") continue;  // not read
        ++looked;
        json without = all;
        without.at(json::json_pointer{pointer.substr(0, pointer.rfind('/'))}).erase(key);
        EXPECT_THAT(refusal(without.dump()), AllOf(HasSubstr(key), HasSubstr("found none"))) << pointer;
        for (const json& other : {json{}, json("text"), json{{"a", 1}}, json{json{1, 2}}, json(-0.5)}) {
            if (other == -0.5 && (key == "near" || key == "far")) continue;
            if (other.is_string() && (key == "name" || key == "node" || key == "mesh" || pointer == "/source/format"))
                continue;  // any text
            EXPECT_THAT(refusalWith(pointer, other), HasSubstr(key)) << pointer << ' ' << other;
        }
    }
    EXPECT_EQ(looked, 38);
}

TEST(ReadLines, refuseEachValueThatIsOutOfRange) {
    const auto says = [](const char* pointer, const json& value, const char* message) {
        EXPECT_THAT(refusalWith(pointer, value), HasSubstr(message)) << pointer;
    };
    says("/size", {0, 5}, "size: expected two whole numbers from 1 to 32768, found 0");
    says("/size", {5, 32769}, "found 32769");
    says("/size", {5.5, 5}, "found 5.5");
    says("/size", {5, 5, 5}, "size: expected a list of 2 numbers, found a list of 3");
    says("/camera/view/2", {1, 2, 3}, "camera.view: expected a list of 4 numbers");
    says("/camera/view", json(4, json(4, 0)), "camera.view: expected a view and a projection that are finite");
    says("/camera/far", 1.0 / 7.0, "expected a view and a projection that are finite");
    says("/camera/view_angle", 180, "camera.view_angle: expected a number over 0 and under 180, found '180'");
    says("/camera/orthographic_height", 0, "camera.orthographic_height: expected a number over 0, found '0'");
    says("/bounds/radius", -1, "bounds.radius: expected a number of at least 0, found '-1'");
    says("/bounds/centre/1", "x", "bounds.centre: expected a list of 3 numbers");
    says("/source/unit", "yard",
         "source.unit: expected one of unknown, metre, millimetre, centimetre, inch, foot, found 'yard'");
    says("/source/space", "image", "source.detector: expected a text, found none");
    says("/source/triangles", 1e300, "source.triangles: expected a whole number from 0 to 9007199254740992");
    says("/source/warnings/0", 5, "source.warnings: expected texts, found '5'");
    says("/instances/1/id", 1, "instances[1].id: expected a number over 1, the last one's, found '1'");
    says("/instances/1", 1, "instances[1]: expected an object, found '1'");
    says("/instances/0/materials/1", -1, "instances[0].materials: expected whole numbers from 0 to 4294967295, found");
    says("/instances/0/transform/2", {1, 2, 3}, "instances[0].transform: expected a list of 4 numbers");
    says("/materials/1/id", 7, "materials[1].id: expected 2, for they are in order, found '7'");
    says("/tolerance", -0.1, "tolerance: expected a number of at least 0");
    says("/lines", json::object(), "lines: expected a list, found an object");
    says("/lines/1", json::array(), "lines[1]: expected an object, found a list of 0");
    says("/lines/1/id", 4294967296, "lines[1].id: expected a whole number from 0 to 4294967295, found '4294967296'");
    says("/lines/1/object", -1, "lines[1].object: expected a whole number");
    says("/lines/1/type", "edge", "lines[1].type: expected one of outline, occlusion,");
    says("/lines/1/pixels", json::array(), "lines[1].pixels: expected a list of two or more, found a list of 0");
    says("/lines/1/positions", json::array(),
         "lines[1].positions: expected a list of 2, as pixels is, found a list of 0");
    says("/lines/0/pixels/2/0", nullptr, "lines[0].pixels: expected a list of 2 numbers, found a list of 2");
    says("/source/name", std::string(5000, 'x') + "\n", "none");  // any text
    says("/source/name", 1, "source.name: expected a text, found '1'");
}

TEST(ReadLines, refuseWhatIsTooDeepOrTooMuch) {
    const auto nested = [](int levels) {
        return fmt::format("{{\"a\": {}{}}}", std::string(static_cast<std::size_t>(levels), '['),
                           std::string(static_cast<std::size_t>(levels), ']'));
    };
    EXPECT_THAT(refusal(nested(15)), StartsWith("format: "));
    EXPECT_EQ(refusal(nested(16)), "expected at most 16 lists and objects in each other, found more");
    EXPECT_EQ(refusal(nested(1 << 20)), "expected at most 16 lists and objects in each other, found more");
    std::string many = "{\"a\": [";
    for (int i = 0; i < (1 << 23); ++i) many += "1,";
    EXPECT_EQ(refusal(many + "1]}"), "expected at most 8388608 values in the file, found more");
    std::string head = valid().dump();
    json all = valid();
    all.erase("lines");
    head = all.dump();
    head.pop_back();
    EXPECT_EQ(refusal(head + ",\"lines\": [" + many + "1]}]}"),
              "expected at most 8388608 values in one of lines, found more");
}

TEST(ReadLines, takeKeysInAnyOrderAndOthersBesideThem) {
    json all = valid();
    all["zzz"] = {{"a", {1, 2, {3}}}};
    all["lines"][0]["zzz"] = "more";
    const std::string sorted = all.dump();
    EXPECT_LT(sorted.find("\"lines\":"), sorted.find("\"version\":"));
    EXPECT_EQ(writtenAgain(sorted, allOfThem()), linesJson(sample(), allOfThem()));
}

TEST(ReadLines, readsFilesAndNamesThemWhereItRefuses) {
    const TemporaryFolder folder;
    writeLines(sample(), allOfThem(), folder / "a.json");
    EXPECT_EQ(linesJson(readLines(folder / "a.json"), allOfThem()), contents(folder / "a.json"));
    const auto refuses = [&](const char* name, const char* message) {
        expectError(Error::Kind::Input, HasSubstr(message), [&] { (void)readLines(folder / name); });
        expectError(Error::Kind::Input, StartsWith((folder / name).string() + ": "),
                    [&] { (void)readLines(folder / name); });
    };
    refuses("missing.json", "expected a file, found none");
    refuses(".", "expected a file, found a folder");
    put(folder / "empty.json", "");
    refuses("empty.json", "expected a file with content, found an empty one");
    put(folder / "svg.json", linesSvg(sample(), {}));
    refuses("svg.json", "expected JSON, found something else at byte 1");
    put(folder / "large.json", "{");
    std::filesystem::resize_file(folder / "large.json", (std::uint64_t{1} << 30U) + 1);
    refuses("large.json", "expected a file of at most 1073741824 bytes, found 1073741825");
}

}  // namespace
}  // namespace inkedge::io

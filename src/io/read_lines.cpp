#include <inkedge/read_lines.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "base/read_file.h"
#include "io/json_object.h"
#include "io/lines_json.h"
#include "io/names_json.h"
#include "io/parse_json.h"
#include "settings/names.h"

namespace inkedge {
namespace {

using Json = io::ParsedJson;
using io::JsonObject;

constexpr std::uint64_t largestFile = std::uint64_t{1} << 30U;   // bytes
constexpr std::uint64_t maxTriangles = std::uint64_t{1} << 53U;  // as many as a double counts
constexpr std::size_t maxValues = std::size_t{1} << 23U;         // of one line, and of all that is no line
constexpr std::size_t maxDepth = 16;                             // lists and objects in each other; 5 are written

Size readSize(const JsonObject& all) {
    const auto size = all.vector<glm::dvec2>("size");
    constexpr int max = PictureSettings::maxSide;
    for (int k = 0; k < 2; ++k) {
        if (size[k] < 1.0 || size[k] > max || size[k] != std::floor(size[k]))
            base::refuse(fmt::format("size: expected two whole numbers from 1 to {}, found {}", max, size[k]));
    }
    return {static_cast<int>(size.x), static_cast<int>(size.y)};
}

// What follows from these, as projection and eye do, is not read.
Camera readCamera(const JsonObject& json, Size size) {
    Camera camera;
    camera.view = io::readMatrix(json, "view");
    camera.near = json.number("near");
    camera.far = json.number("far");
    if (json.at("orthographic_height") != nullptr) {
        camera.orthographicHeight = json.number("orthographic_height");
        if (!camera.orthographic())
            io::refuseValue(json.path("orthographic_height"), "a number over 0", json.at("orthographic_height"));
    } else {
        camera.viewAngle = json.number("view_angle");
        if (!(camera.viewAngle > 0.0 && camera.viewAngle < 180.0))
            io::refuseValue(json.path("view_angle"), "a number over 0 and under 180", json.at("view_angle"));
    }
    if (json.at("axis") != nullptr) camera.axis = json.vector<glm::dvec2>("axis");
    if (json.at("pixel_aspect") != nullptr) {
        camera.pixelAspect = json.number("pixel_aspect");
        if (!(camera.pixelAspect > 0.0))
            io::refuseValue(json.path("pixel_aspect"), "a number over 0", json.at("pixel_aspect"));
    }
    if (!io::isFinite(camera, size))
        base::refuse(json.path("view") +
                     ": expected a view and a projection that are finite, as the view's inverse is, "
                     "found none");
    return camera;
}

LinesSource readSource(const JsonObject& json) {
    LinesSource source;
    source.name = json.text("name");
    source.format = json.text("format");
    source.unit = static_cast<LengthUnit>(json.choice("unit", io::lengthUnitNames));
    source.triangles = json.whole("triangles", maxTriangles);
    for (const Json& warning : json.list("warnings")) {
        if (!warning.is_string()) io::refuseValue(json.path("warnings"), "texts", &warning);
        source.warnings.push_back(warning.get<std::string>());
    }
    if (json.choice("space", io::spaceNames) == 0) {
        source.finder = static_cast<ContourFinder>(json.choice("contour_finder", settings::contourFinderNames));
    } else {
        source.space = LinesFrom::Image;
        source.detector = static_cast<Detector>(json.choice("detector", settings::detectorNames));
    }
    return source;
}

void readStrengths(const JsonObject& json, Line& line) {
    const Json& strengths = json.list("strengths");
    const std::string path = json.path("strengths");
    if (strengths.size() != line.points.size())
        io::refuseValue(path, fmt::format("a list of {}, as pixels is", line.points.size()), &strengths);
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        const double strength = strengths[i].is_number() ? strengths[i].get<double>() : -1.0;
        if (!(strength >= 0.0 && strength <= 1.0)) io::refuseValue(path, "numbers from 0 to 1", &strengths[i]);
        line.points[i].strength = strength;
    }
}

Line readLine(const JsonObject& json) {
    Line line;
    line.id = json.whole32("id");
    line.type = static_cast<LineType>(1U << json.choice("type", settings::lineTypeNames));
    line.visible = json.flag("visible");
    line.closed = json.flag("closed");
    line.object = json.whole32("object");
    line.patch = json.whole32("patch");
    if (json.at("width") != nullptr) {
        line.width = json.number("width");
        if (!(line.width > 0.0 && line.width <= 1.0))
            io::refuseValue(json.path("width"), "a number over 0 and at most 1", json.at("width"));
    }
    const Json& pixels = json.list("pixels");
    const Json& positions = json.list("positions");
    if (pixels.size() < 2) io::refuseValue(json.path("pixels"), "a list of two or more", &pixels);
    if (positions.size() != pixels.size())
        io::refuseValue(json.path("positions"), fmt::format("a list of {}, as pixels is", pixels.size()), &positions);
    line.points.reserve(pixels.size());
    const std::array paths{json.path("pixels"), json.path("positions")};
    for (std::size_t i = 0; i < pixels.size(); ++i)
        line.points.push_back(
            {io::vectorOf<glm::dvec2>(pixels[i], paths[0]), io::vectorOf<glm::dvec3>(positions[i], paths[1])});
    if (formLineTypes.contains(line.type)) readStrengths(json, line);
    return line;
}

// @param whole  whether all of the file has been read, and not only what stands before its lines
void expectOurFormat(const Json& json, bool whole) {
    const auto expectValue = [&](const char* key, const Json& expected, std::string_view remedy) {
        const auto found = json.find(key);
        if (found == json.end() ? whole : *found != expected)
            io::refuseValue(key, fmt::format("{}{}", expected.dump(), remedy), found == json.end() ? nullptr : &*found);
    };
    expectValue("format", io::linesFormat, "");
    expectValue("version", io::linesVersion, "; find the lines again");
}

}  // namespace

Lines linesFromJson(std::string_view text) {
    Lines lines;
    const auto take = [&](const Json& line, const Json& before) {
        if (lines.lines.empty()) expectOurFormat(before, false);
        lines.lines.push_back(readLine({&line, fmt::format("lines[{}]", lines.lines.size())}));
    };
    const Json json = io::parseJson(text, {"lines", take}, {maxDepth, maxValues});
    const JsonObject all{&json, ""};
    expectOurFormat(json, true);
    (void)all.list("lines");
    lines.size = readSize(all);
    lines.camera = readCamera(all.object("camera"), lines.size);
    const JsonObject bounds = all.object("bounds");
    lines.bounds = {bounds.vector<glm::dvec3>("centre"), bounds.notNegative("radius")};
    lines.source = readSource(all.object("source"));
    lines.names = io::readNames(all);
    lines.tolerance = all.notNegative("tolerance");
    return lines;
}

Lines readLines(const std::filesystem::path& file) {
    return base::within(base::printable(file.string()), [&] {
        std::error_code failure;
        if (const std::uint64_t size = std::filesystem::file_size(file, failure); !failure && size > largestFile)
            base::refuse(fmt::format("expected a file of at most {} bytes, found {}", largestFile, size));
        std::uint64_t bytesLeft = largestFile;
        const base::Bytes bytes = base::readBytes(file, bytesLeft);
        return linesFromJson(base::textOf(bytes));
    });
}

}  // namespace inkedge

#include "io/lines_json.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "curves/simplify.h"
#include "io/metadata.h"
#include "io/names_json.h"
#include "settings/names.h"
#include "settings/pens.h"

namespace inkedge {
namespace {

using io::Json;

constexpr double millionth = 1e-6;  // of the model's radius: world positions are rounded to it
constexpr double thousand = 1e3;    // pixel positions and widths are rounded to thousandths

// To a power of ten, 1 / step of it; written without needless digits. A number so large that the step is lost in it
// stays as it is: rounding what was rounded changes nothing.
std::string rounded(double value, double perUnit) {
    constexpr double largest = 562949953421312.0;  // 2^49: up to here dividing and multiplying keep a whole number
    const double scaled = value * perUnit;
    const double result = std::abs(scaled) < largest ? std::round(scaled) / perUnit : value;
    return fmt::format("{}", std::isfinite(result) ? result + 0.0 : value);  // + 0.0: never -0
}

double positionsPerUnit(const Sphere& bounds) {
    const double step = std::max(bounds.radius * millionth, 1e-300);
    return std::pow(10.0, std::ceil(-std::log10(step)));
}

std::string lineText(const Line& line, double perUnit) {
    std::string pixels;
    std::string positions;
    std::string strengths;
    for (const LinePoint& p : line.points) {
        const std::string_view comma = pixels.empty() ? "" : ",";
        pixels += fmt::format("{}[{},{}]", comma, rounded(p.pixel.x, thousand), rounded(p.pixel.y, thousand));
        positions += fmt::format("{}[{},{},{}]", comma, rounded(p.position.x, perUnit), rounded(p.position.y, perUnit),
                                 rounded(p.position.z, perUnit));
        strengths += fmt::format("{}{}", comma, rounded(p.strength, thousand));
    }
    const std::string width =
        line.width < 1.0 ? fmt::format("\"width\":{},", rounded(std::max(line.width, 1.0 / thousand), thousand)) : "";
    const std::string strength =
        formLineTypes.contains(line.type) ? fmt::format(R"(,"strengths":[{}])", strengths) : "";
    return fmt::format(
        R"({{"id":{},"type":"{}","visible":{},"closed":{},"object":{},"patch":{},{}"pixels":[{}],"positions":[{}]{}}})",
        line.id, name(line.type), line.visible, line.closed, line.object, line.patch, width, pixels, positions,
        strength);
}

bool isFinite(glm::dvec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool isFinite(glm::dvec3 v) { return isFinite(glm::dvec2{v}) && std::isfinite(v.z); }

// As it is written, but for rounding.
Line written(Line line, double tolerance) {
    std::erase_if(line.points, [](const LinePoint& p) {
        return !isFinite(p.pixel) || !isFinite(p.position) || !std::isfinite(p.strength);
    });
    return tolerance > 0.0 ? curves::simplify(line, tolerance) : line;
}

Json sourceJson(const LinesSource& source) {
    const bool image = source.space == LinesFrom::Image;
    Json json{{"name", source.name},
              {"format", source.format},
              {"unit", io::lengthUnitNames[static_cast<std::size_t>(source.unit)]},
              {"triangles", source.triangles},
              {"warnings", source.warnings},
              {"space", io::spaceNames[image ? 1 : 0]}};
    if (image) {
        json["detector"] = settings::detectorNames[static_cast<std::size_t>(source.detector)];
    } else {
        json["contour_finder"] = settings::contourFinderNames[static_cast<std::size_t>(source.finder)];
    }
    return json;
}

void expectWritable(const Lines& lines) {
    if (lines.size.width < 1 || lines.size.height < 1) {
        throw Error{Error::Kind::Usage,
                    "lines: expected a picture of at least one pixel, found none; were they drawn?"};
    }
    if (!io::isFinite(lines.camera, lines.size) || !isFinite(lines.bounds.centre) ||
        !std::isfinite(lines.bounds.radius) || !std::isfinite(lines.tolerance)) {
        throw Error{Error::Kind::Usage, "lines: expected a camera, bounds and a tolerance that are finite, found none"};
    }
}

}  // namespace

namespace io {

bool isFinite(const Camera& camera, Size size) noexcept {
    const auto all = [](const glm::dmat4& m) {
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(m[column][row])) return false;
        }
        return true;
    };
    return std::isfinite(camera.near) && std::isfinite(camera.far) && all(camera.view) &&
           all(camera.projection(size)) && all(glm::inverse(camera.view));
}

}  // namespace io

std::string linesJson(const Lines& lines, const Settings& settings) {
    expectWritable(lines);
    const double tolerance = std::max(settings.lines.simplify, lines.tolerance);
    const Json head{{"format", io::linesFormat},
                    {"version", io::linesVersion},
                    {"units", {{"pixels", "(0, 0) the top left corner, y down"}, {"positions", "world space"}}},
                    {"size", {lines.size.width, lines.size.height}},
                    {"camera", io::cameraJson(lines.camera, lines.size)},
                    {"bounds", io::boundsJson(lines.bounds)},
                    {"source", sourceJson(lines.source)},
                    {"instances", io::instancesJson(lines.names)},
                    {"materials", io::materialsJson(lines.names)},
                    {"tolerance", tolerance},
                    {"settings", io::settingsJson(settings)}};
    std::string text = io::textOf(head, 2);
    text.erase(text.rfind('\n'));  // the line with the last brace
    text += ",\n  \"lines\": [";
    const double perUnit = positionsPerUnit(lines.bounds);
    std::string_view separator = "\n";
    for (const Line& line : lines.lines) {
        if (!settings::isDrawn(line, settings.picture, settings.lines)) continue;
        const Line simple = written(line, tolerance - lines.tolerance);
        if (simple.points.size() < 2) continue;
        text += separator;
        text += lineText(simple, perUnit);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

}  // namespace inkedge

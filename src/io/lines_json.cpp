#include <inkedge/write.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "curves/simplify.h"
#include "ink/pens.h"
#include "io/metadata.h"

namespace inkedge {
namespace {

constexpr double millionth = 1e-6;  // of the model's radius: world positions are rounded to it
constexpr double thousand = 1e3;    // pixel positions are rounded to thousandths

// A value rounded to 1 / perUnit, a power of ten, without needless digits.
std::string rounded(double value, double perUnit) {
    const double result = std::round(value * perUnit) / perUnit;
    return fmt::format("{}", std::isfinite(result) ? result + 0.0 : value);
}

double pointsPerUnit(const Scene& scene) {
    const double step = std::max(scene.bounds().radius * millionth, 1e-300);
    return std::pow(10.0, std::ceil(-std::log10(step)));
}

std::string lineText(const Line& line, double perUnit) {
    std::string pixels;
    std::string points;
    for (const LinePoint& p : line.points) {
        const std::string_view comma = pixels.empty() ? "" : ",";
        pixels += fmt::format("{}[{},{}]", comma, rounded(p.pixel.x, thousand), rounded(p.pixel.y, thousand));
        points += fmt::format("{}[{},{},{}]", comma, rounded(p.position.x, perUnit), rounded(p.position.y, perUnit),
                              rounded(p.position.z, perUnit));
    }
    return fmt::format(R"({{"type":"{}","visible":{},"closed":{},"object":{},"patch":{},"places":[{}],"points":[{}]}})",
                       name(line.type), line.visible, line.closed, line.object, line.patch, pixels, points);
}

}  // namespace

std::string linesJson(const Scene& scene, const Lines& lines, const Settings& settings) {
    const Size size = lines.size;
    if (size.width < 1 || size.height < 1) {
        throw Error{Error::Kind::Usage,
                    "lines: expected a picture of at least one pixel, found none; were they drawn?"};
    }
    const io::Json head{
        {"format", "inkedge lines"},
        {"version", 1},
        {"units", {{"places", "pixels, (0, 0) the top left corner, y down"}, {"points", "world space"}}},
        {"size", {size.width, size.height}},
        {"camera", io::cameraJson(lines.camera, size)},
        {"bounds", io::boundsJson(scene.bounds())},
        {"settings", io::settingsJson(settings)}};
    std::string text = io::textOf(head, 2);
    text.erase(text.rfind('\n'));  // the line with the last brace
    text += ",\n  \"lines\": [";
    const double perUnit = pointsPerUnit(scene);
    std::string_view separator = "\n";
    for (const Line& line : lines.lines) {
        if (!isDrawn(line, settings.picture, settings.lines)) continue;
        const Line simple = settings.lines.simplify > 0.0 ? simplify(line, settings.lines.simplify) : line;
        if (simple.points.size() < 2) continue;
        text += separator;
        text += lineText(simple, perUnit);
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

}  // namespace inkedge

#include <inkedge/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "curves/clip.h"
#include "curves/fit_beziers.h"
#include "curves/simplify.h"
#include "ink/pens.h"
#include "ink/strokes_of.h"
#include "io/metadata.h"
#include "io/svg_path.h"

namespace inkedge {
namespace {

constexpr double millimetresPerInch = 25.4;
constexpr double cssDpi = 96.0;  // pixels per inch where a document does not say otherwise

// A number with at most three decimals.
std::string number(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

// Whether lines are written as outlines of strokes, because their widths vary.
bool varies(const LineSettings& settings) {
    return settings.strokeWidth != StrokeWidth::Constant || settings.strokeTaper > 0.0;
}

std::string hex(Color color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }

// Text for XML 1.0: UTF-8 without the characters that no document may have, markup as entities.
std::string escaped(std::string_view text) {
    std::string valid = io::Json::parse(io::textOf(std::string{text}, -1)).get<std::string>();
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {  // U+FFFE, U+FFFF
        for (std::size_t at = 0; (at = valid.find(none, at)) != std::string::npos;)
            valid.replace(at, 3, "\xEF\xBF\xBD");
    }
    std::string result;
    for (const char c : valid) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
        }
    }
    return result;
}

// The settings with the resolution at which the picture fills its page.
PictureSettings onPage(PictureSettings settings, Size size) {
    if (settings.page) {
        const double millimetresPerPixel =
            std::min(settings.page->width / size.width, settings.page->height / size.height);
        settings.dpi = millimetresPerInch / millimetresPerPixel;
    }
    return settings;
}

// Whether the document's size is given in millimetres.
bool isPhysical(const PictureSettings& settings) {
    bool physical = settings.page || settings.dpi != cssDpi || settings.lineWidth.millimetres;
    for (const PenSettings& pen : settings.pens) physical = physical || (pen.width && pen.width->millimetres);
    return physical;
}

std::string documentSize(const PictureSettings& settings, Size size) {
    if (!isPhysical(settings)) return fmt::format("width=\"{}\" height=\"{}\"", size.width, size.height);
    const double perPixel = millimetresPerInch / settings.dpi;
    const PageSize page = settings.page.value_or(PageSize{size.width * perPixel, size.height * perPixel});
    return fmt::format("width=\"{}mm\" height=\"{}mm\"", number(page.width), number(page.height));
}

bool isStraight(const curves::Bezier& curve) {
    constexpr double visible = 0.005;  // pixels: half the last decimal
    const glm::dvec2 along = curve[3] - curve[0];
    const double length = glm::length(along);
    const auto isOn = [&](glm::dvec2 p) {
        const glm::dvec2 off = p - curve[0];
        if (length == 0.0) return glm::length(off) < visible;
        const double way = glm::dot(off, along) / length;
        return std::abs(off.x * along.y - off.y * along.x) < visible * length && way >= 0.0 && way <= length;
    };
    return isOn(curve[1]) && isOn(curve[2]);
}

void addCurves(io::SvgPath& path, const Line& line, double tolerance) {
    const std::vector<curves::Bezier> curves = curves::fitBeziers(line, tolerance);
    if (curves.empty()) return;
    path.moveTo(curves.front()[0]);
    for (const curves::Bezier& curve : curves) {
        if (isStraight(curve)) {
            path.lineTo(curve[3]);
        } else {
            path.curveTo(curve[1], curve[2], curve[3]);
        }
    }
    if (line.closed) path.close();
}

void addPolyline(io::SvgPath& path, const Line& line, double tolerance) {
    const Line simple = curves::simplify(line, tolerance);
    if (simple.points.size() < 2) return;
    path.moveTo(simple.points.front().pixel);
    for (std::size_t i = 1; i < simple.points.size(); ++i) path.lineTo(simple.points[i].pixel);
    if (line.closed) path.close();
}

// Adds the outline of a stroke: straight along its sides, round at its ends. All run clockwise, so that overlapping
// strokes fill the union of their areas.
void addOutline(io::SvgPath& path, const ink::Stroke& stroke, double penWidth) {
    const double from = 0.5 * penWidth * stroke.widthFrom / ink::fullWidth;
    const double to = 0.5 * penWidth * stroke.widthTo / ink::fullWidth;
    const glm::dvec2 a{stroke.from};
    const glm::dvec2 b{stroke.to};
    const double length = glm::distance(a, b);
    const glm::dvec2 along = length > 0.0 ? (b - a) / length : glm::dvec2{1.0, 0.0};
    const glm::dvec2 left{along.y, -along.x};
    path.moveTo(a + from * left);
    path.lineTo(b + to * left);
    path.arcTo(to, b - to * left);
    path.lineTo(a - from * left);
    path.arcTo(from, a + from * left);
    path.close();
}

// The rounding of coordinates, as fine as the lines: half a tenth is a fifth of the usual tolerance.
io::SvgPath::Step stepFor(const LineSettings& settings) {
    constexpr double coarse = 0.25;  // pixels
    const double tolerance = settings.fitCurves > 0.0 ? settings.fitCurves : settings.simplify;
    return tolerance >= coarse && !varies(settings) ? io::SvgPath::Step::Tenth : io::SvgPath::Step::Hundredth;
}

using Paths = std::map<std::uint32_t, io::SvgPath>;

std::array<Paths, ink::penCount> pathsOf(const Lines& lines, const PictureSettings& picture,
                                         const LineSettings& settings) {
    const auto allPens = ink::pens(picture);
    const glm::dvec2 size{lines.size.width, lines.size.height};
    const double tolerance = std::max(settings.simplify - lines.tolerance, 0.0);  // what is left of it
    std::array<Paths, ink::penCount> paths;
    if (varies(settings)) {
        const ink::StrokeMaker maker{lines, picture, settings, tolerance};
        std::vector<ink::Stroke> strokes;
        for (const Line& line : lines.lines) {
            strokes.clear();
            maker.add(line, strokes);
            for (const ink::Stroke& stroke : strokes) {
                addOutline(paths[stroke.pen][line.object], stroke, allPens[stroke.pen].width);
            }
        }
        return paths;
    }
    for (const Line& line : lines.lines) {
        if (!ink::isDrawn(line, picture, settings)) continue;
        const std::uint8_t pen = ink::penOf(line);
        const double margin = 0.5 * allPens[pen].width;
        for (const Line& part : curves::clip(line, glm::dvec2{-margin}, size + margin)) {
            io::SvgPath& path = paths[pen].try_emplace(line.object, stepFor(settings)).first->second;
            if (settings.fitCurves > 0.0) {
                addCurves(path, part, settings.fitCurves);
            } else {
                addPolyline(path, part, tolerance);
            }
        }
    }
    return paths;
}

std::string group(std::size_t number_, const ink::Pen& pen, const Paths& paths, const LineSettings& settings) {
    const bool isHidden = number_ >= lineTypeCount;
    const auto type = static_cast<LineType>(1U << (number_ % lineTypeCount));
    std::string ink = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", hex(pen.color), number(pen.width));
    if (varies(settings)) {
        ink = fmt::format("fill=\"{}\"", hex(pen.color));
    } else if (isHidden && settings.hidden == HiddenLines::Dashed) {
        ink += fmt::format(" stroke-dasharray=\"{} {}\"", number(ink::dashLength * pen.width),
                           number(ink::gapLength * pen.width));
    }
    std::string text =
        fmt::format("<g class=\"inkedge {} {}\" {}>\n", name(type), isHidden ? "hidden" : "visible", ink);
    for (const auto& [object, path] : paths) {
        const std::string data = path.text();
        if (!data.empty()) text += fmt::format("<path data-object=\"{}\" d=\"{}\"/>\n", object, data);
    }
    return text + "</g>\n";
}

}  // namespace

std::string linesSvg(const Lines& lines, const Settings& settings, std::string_view title) {
    const Size size = lines.size;
    if (size.width < 1 || size.height < 1) {
        throw Error{Error::Kind::Usage,
                    "lines: expected a picture of at least one pixel, found none; were they drawn?"};
    }
    if (!settings.lines.brush.empty()) {
        throw Error{
            Error::Kind::Usage,
            "brush: expected a picture of pixels, found SVG, which has no textures; leave it out, or write a .png"};
    }
    const PictureSettings picture = onPage(settings.picture, size);
    const io::Json metadata{{"camera", io::cameraJson(lines.camera, size)},
                            {"size", {size.width, size.height}},
                            {"bounds", io::boundsJson(lines.bounds)},
                            {"settings", io::settingsJson(settings)}};
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" {} viewBox=\"0 0 {} {}\" fill=\"none\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n<title>{}</title>\n<desc>Line drawing of a 3D model, {} x {} pixels</desc>\n"
        "<metadata>{}</metadata>\n",
        documentSize(picture, size), size.width, size.height, escaped(title), size.width, size.height,
        escaped(io::textOf(metadata, -1)));
    if (picture.background) {
        text += fmt::format("<rect class=\"inkedge background\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", size.width,
                            size.height, hex(*picture.background));
    }
    if (picture.page) {  // its margins would show what lies beyond the picture's edges
        text += fmt::format(
            "<clipPath id=\"picture\"><rect width=\"{}\" height=\"{}\"/></clipPath>\n"
            "<g clip-path=\"url(#picture)\">\n",
            size.width, size.height);
    }
    const auto allPens = ink::pens(picture);
    const auto paths = pathsOf(lines, picture, settings.lines);
    for (std::size_t i = paths.size(); i-- > 0;) {  // the first covers the others, and is written last
        if (!paths[i].empty()) text += group(i, allPens[i], paths[i], settings.lines);
    }
    return text + (picture.page ? "</g>\n</svg>\n" : "</svg>\n");
}

}  // namespace inkedge

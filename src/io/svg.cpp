#include <inkedge/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "curves/clip.h"
#include "curves/fit_beziers.h"
#include "curves/order_paths.h"
#include "curves/simplify.h"
#include "ink/strokes_of.h"
#include "io/metadata.h"
#include "io/sheet.h"
#include "io/svg_image.h"
#include "io/svg_path.h"
#include "settings/pens.h"

namespace inkedge {
namespace {

// A number with at most three decimals, rounded.
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

// A length with at most three decimals, rounded down: a pixel that is only begun counts as one in librsvg.
std::string millimetres(double length) {
    constexpr double noise = 1e-6;  // of a thousandth: 20 is not 19.999 for being 19.99999999999
    return number(std::floor(length * 1000.0 + noise) / 1000.0) + "mm";
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

// The same for the value of an attribute.
std::string quoted(std::string_view text) {
    std::string value = escaped(text);
    for (std::size_t at = 0; (at = value.find('"', at)) != std::string::npos;) value.replace(at, 1, "&quot;");
    return '"' + value + '"';
}

// The size and the coordinates of the document. They are of one shape: not all readers know preserveAspectRatio.
std::string documentSize(const io::Sheet& sheet) {
    const std::string viewBox = fmt::format("viewBox=\"0 0 {} {}\"", number(sheet.size.x), number(sheet.size.y));
    if (!sheet.paper)
        return fmt::format("width=\"{}\" height=\"{}\" {}", number(sheet.size.x), number(sheet.size.y), viewBox);
    return fmt::format("width=\"{}\" height=\"{}\" {}", millimetres(sheet.paper->width),
                       millimetres(sheet.paper->height), viewBox);
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

// Half the width of an end of a stroke.
double radius(std::uint8_t width, double penWidth) { return 0.5 * penWidth * width / ink::fullWidth; }

// Adds the outline of a stroke: straight along its sides, round at its ends. All run clockwise, so that overlapping
// strokes fill the union of their areas.
void addOutline(io::SvgPath& path, const ink::Stroke& stroke, double penWidth) {
    const double from = radius(stroke.widthFrom, penWidth);
    const double to = radius(stroke.widthTo, penWidth);
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

// What is one path: lines of one object and one width, in 128ths of the pen's, or one line in the order of travel.
struct PathKey {
    std::size_t first;  // how many paths of the pen come before it; 0 in the order drawn
    std::uint32_t object;
    std::uint8_t width;
    friend auto operator<=>(const PathKey&, const PathKey&) = default;
};
using Paths = std::map<PathKey, io::SvgPath>;
using Names = std::map<std::uint32_t, std::string_view>;  // by object

struct Drawing {
    std::array<Paths, settings::penCount> paths;  // by pen
    bool isCut = false;                           // whether some ink lies beyond the picture's edges
};

bool reachesBeyond(glm::dvec2 size, glm::dvec2 pixel, double by) {
    return pixel.x < by || pixel.y < by || pixel.x > size.x - by || pixel.y > size.y - by;
}

void addOutlines(Drawing& drawing, const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
                 double tolerance) {
    const auto allPens = settings::pens(picture);
    const glm::dvec2 size{lines.size.width, lines.size.height};
    const ink::StrokeMaker maker{lines, picture, settings, tolerance};
    std::vector<ink::Stroke> strokes;
    for (const Line& line : lines.lines) {
        strokes.clear();
        maker.add(line, strokes);
        for (const ink::Stroke& stroke : strokes) {
            const double width = allPens[stroke.pen].width;
            addOutline(drawing.paths[stroke.pen][{0, line.object, ink::fullWidth}], stroke, width);
            drawing.isCut = drawing.isCut || reachesBeyond(size, stroke.from, radius(stroke.widthFrom, width)) ||
                            reachesBeyond(size, stroke.to, radius(stroke.widthTo, width));
        }
    }
}

// The lines that are drawn, cut at the picture's edges, by pen.
std::array<std::vector<Line>, settings::penCount> drawnParts(const Lines& lines, const PictureSettings& picture,
                                                             const LineSettings& settings) {
    const auto allPens = settings::pens(picture);
    const glm::dvec2 size{lines.size.width, lines.size.height};
    std::array<std::vector<Line>, settings::penCount> parts;
    for (const Line& line : lines.lines) {
        if (!settings::isDrawn(line, picture, settings)) continue;
        const std::uint8_t pen = settings::penOf(line);
        const double margin = 0.5 * allPens[pen].width;
        for (Line& part : curves::clip(line, glm::dvec2{-margin}, size + margin)) parts[pen].push_back(std::move(part));
    }
    return parts;
}

void addCentreLines(Drawing& drawing, const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
                    double tolerance) {
    const auto allPens = settings::pens(picture);
    const glm::dvec2 size{lines.size.width, lines.size.height};
    const bool travels = settings.pathOrder == PathOrder::Travel;
    auto parts = drawnParts(lines, picture, settings);
    glm::dvec2 penAt{0.0};
    for (std::size_t pen = parts.size(); pen-- > 0;) {  // as they are written
        if (travels) parts[pen] = curves::inTravelOrder(std::move(parts[pen]), penAt);
        const double margin = 0.5 * allPens[pen].width;
        std::size_t first = 0;
        for (const Line& part : parts[pen]) {
            const PathKey key{travels ? first++ : 0, part.object, ink::levelOf(part.width)};
            io::SvgPath& path = drawing.paths[pen].try_emplace(key, stepFor(settings)).first->second;
            for (const LinePoint& point : part.points)
                drawing.isCut = drawing.isCut || reachesBeyond(size, point.pixel, margin + settings.fitCurves);
            if (settings.fitCurves > 0.0) {
                addCurves(path, part, settings.fitCurves);
            } else {
                addPolyline(path, part, tolerance);
            }
        }
    }
}

Drawing drawingOf(const Lines& lines, const PictureSettings& picture, const LineSettings& settings) {
    Drawing drawing;
    const double tolerance = std::max(settings.simplify - lines.tolerance, 0.0);  // what is left of it
    const auto add = varies(settings) ? addOutlines : addCentreLines;
    add(drawing, lines, picture, settings, tolerance);
    return drawing;
}

std::string inkOf(const settings::Pen& pen, bool isHidden, const LineSettings& settings) {
    if (varies(settings)) return fmt::format("fill=\"{}\"", hex(pen.color));
    std::string ink = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", hex(pen.color), number(pen.width));
    if (isHidden && settings.hidden == HiddenLines::Dashed)
        ink += fmt::format(" stroke-dasharray=\"{} {}\"", number(pen.dash), number(pen.gap));
    return ink;
}

// A group is a layer of Inkscape's, and of the DXF files that it writes. The class of type and visibility together is
// for style sheets: LibreOffice reads selectors of one class alone.
std::string group(std::size_t pen, double penWidth, const std::string& ink, const std::string& attributes,
                  const Paths& paths, const Names& names) {
    const std::string_view type = name(static_cast<LineType>(1U << (pen % lineTypeCount)));
    const std::string_view visibility = pen < lineTypeCount ? "visible" : "hidden";
    std::string text = fmt::format(
        "<g class=\"inkedge {0} {1} {0}-{1}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}-{1}\" {2}{3}>\n", type,
        visibility, ink, attributes);
    for (const auto& [key, path] : paths) {
        const auto known = names.find(key.object);
        const std::string name = known == names.end() ? std::string{} : " data-name=" + quoted(known->second);
        const std::string width = key.width == ink::fullWidth
                                      ? ""
                                      : fmt::format(" stroke-width=\"{}\"", number(2.0 * radius(key.width, penWidth)));
        for (const std::string& data : path.texts())
            text += fmt::format("<path data-object=\"{}\"{}{} d=\"{}\"/>\n", key.object, name, width, data);
    }
    return text + "</g>\n";
}

std::string heading(const Lines& lines, const Settings& settings, const io::Sheet& sheet, std::string_view title) {
    const Size size = lines.size;
    const io::Json metadata{{"camera", io::cameraJson(lines.camera, size)},
                            {"size", {size.width, size.height}},
                            {"bounds", io::boundsJson(lines.bounds)},
                            {"settings", io::settingsJson(settings)}};
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" {}{} "
        "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{}</title>\n"
        "<desc>Line drawing of a 3D model, {} x {} pixels</desc>\n<metadata>{}</metadata>\n",
        lines.shade.empty() ? "" : "xmlns:xlink=\"http://www.w3.org/1999/xlink\" ", documentSize(sheet), escaped(title),
        size.width, size.height, escaped(io::textOf(metadata, -1)));
}

void expectDrawable(const Lines& lines, const Settings& settings) {
    if (lines.size.width < 1 || lines.size.height < 1) {
        throw Error{Error::Kind::Usage,
                    "lines: expected a picture of at least one pixel, found none; were they drawn?"};
    }
    if (!settings.lines.brush.empty()) {
        throw Error{
            Error::Kind::Usage,
            "brush: expected a picture of pixels, found SVG, which has no textures; leave it out, or write a .png"};
    }
}

}  // namespace

std::string linesSvg(const Lines& lines, const Settings& settings, std::string_view title) {
    expectDrawable(lines, settings);
    const Size size = lines.size;
    const io::Sheet sheet = io::sheetOf(settings, size);
    PictureSettings picture = settings.picture;
    picture.dpi = sheet.dpi;
    const bool hasMargins =
        std::max(std::abs(sheet.picture.x), std::abs(sheet.picture.y)) >= 0.001;  // the last decimal
    std::string attributes;
    if (hasMargins)
        attributes = fmt::format(" transform=\"translate({} {})\"", number(sheet.picture.x), number(sheet.picture.y));

    std::string text = heading(lines, settings, sheet, title);
    if (picture.background) {
        text += fmt::format("<rect class=\"inkedge background\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                            number(sheet.size.x), number(sheet.size.y), hex(*picture.background));
    }
    if (!lines.shade.empty()) text += io::svgImage(lines.shade, attributes);
    const Drawing drawing = drawingOf(lines, picture, settings.lines);
    if (hasMargins && drawing.isCut) {  // the margins would show what lies beyond the picture's edges
        text += fmt::format("<clipPath id=\"picture\"><rect width=\"{}\" height=\"{}\"/></clipPath>\n", size.width,
                            size.height);
        attributes += " clip-path=\"url(#picture)\"";
    }
    Names names;
    for (const NamedInstance& instance : lines.names.instances) names.emplace(instance.id, instance.node);
    const auto allPens = settings::pens(picture);
    for (std::size_t i = drawing.paths.size(); i-- > 0;) {  // the first covers the others, and is written last
        if (drawing.paths[i].empty()) continue;
        text += group(i, allPens[i].width, inkOf(allPens[i], i >= lineTypeCount, settings.lines), attributes,
                      drawing.paths[i], names);
    }
    return text + "</svg>\n";
}

}  // namespace inkedge

#include "io/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "curves/clip.h"
#include "curves/fit_beziers.h"
#include "curves/order_paths.h"
#include "curves/simplify.h"
#include "ink/strokes_of.h"
#include "io/metadata.h"
#include "settings/pens.h"

namespace inkedge::io {
namespace {

bool varies(const LineSettings& settings) {
    return settings.strokeWidth != StrokeWidth::Constant || settings.strokeTaper > 0.0;
}

bool isOutlined(const LineSettings& settings, VaryingWidths widths) {
    return widths == VaryingWidths::Outlines && varies(settings);
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

void addCurves(Path& path, const Line& line, double tolerance) {
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

void addPolyline(Path& path, const Line& line, double tolerance) {
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
void addOutline(Path& path, const ink::Stroke& stroke, double penWidth) {
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

// What is one path: lines of one object and one width, in 128ths of the pen's, or one line in the order of travel.
struct PathKey {
    std::size_t first;  // how many paths of the pen come before it; 0 in the order drawn
    std::uint32_t object;
    std::uint8_t width;
    friend auto operator<=>(const PathKey&, const PathKey&) = default;
};
using Paths = std::map<PathKey, Path>;

struct PenPaths {
    std::array<Paths, settings::penCount> paths;  // by pen
    bool isCut = false;                           // as LineLayers::isCut
};

bool reachesBeyond(glm::dvec2 size, glm::dvec2 pixel, double by) {
    return pixel.x < by || pixel.y < by || pixel.x > size.x - by || pixel.y > size.y - by;
}

void addOutlines(PenPaths& drawn, const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
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
            addOutline(drawn.paths[stroke.pen][{0, line.object, ink::fullWidth}], stroke, width);
            drawn.isCut = drawn.isCut || reachesBeyond(size, stroke.from, radius(stroke.widthFrom, width)) ||
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

void addCentreLines(PenPaths& drawn, const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
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
            Path& path = drawn.paths[pen][{travels ? first++ : 0, part.object, ink::levelOf(part.width)}];
            for (const LinePoint& point : part.points)
                drawn.isCut = drawn.isCut || reachesBeyond(size, point.pixel, margin + settings.fitCurves);
            if (settings.fitCurves > 0.0) {
                addCurves(path, part, settings.fitCurves);
            } else {
                addPolyline(path, part, tolerance);
            }
        }
    }
}

Layer layerOf(std::size_t pen, const settings::Pen& ink, Paths paths, const LineSettings& settings,
              VaryingWidths widths) {
    const std::string_view type = name(static_cast<LineType>(1U << (pen % lineTypeCount)));
    const bool isHidden = pen >= lineTypeCount;
    const std::string_view visibility = isHidden ? "hidden" : "visible";
    Layer layer;
    layer.name = fmt::format("{}-{}", type, visibility);
    layer.classes = fmt::format("{0} {1} {0}-{1}", type, visibility);
    layer.color = ink.color;
    layer.width = ink.width;
    layer.filled = isOutlined(settings, widths);
    if (isHidden && settings.hidden == HiddenLines::Dashed && !layer.filled) {
        layer.dash = ink.dash;
        layer.gap = ink.gap;
    }
    for (auto& [key, path] : paths)
        layer.paths.push_back({std::move(path), 2.0 * radius(key.width, ink.width), key.object});
    return layer;
}

void expectDrawable(const Lines& lines, const Settings& settings) {
    if (lines.size.width < 1 || lines.size.height < 1) {
        throw Error{Error::Kind::Usage,
                    "lines: expected a picture of at least one pixel, found none; were they drawn?"};
    }
    if (!settings.lines.brush.empty()) {
        throw Error{Error::Kind::Usage,
                    "brush: expected a picture of pixels, found a file of vectors, which has no textures; leave it "
                    "out, or write a .png"};
    }
}

std::string metadataOf(const Lines& lines, const Settings& settings) {
    const Json metadata{{"camera", cameraJson(lines.camera, lines.size)},
                        {"size", {lines.size.width, lines.size.height}},
                        {"bounds", boundsJson(lines.bounds)},
                        {"settings", settingsJson(settings)}};
    return textOf(metadata, -1);
}

}  // namespace

double stepFor(const LineSettings& settings, VaryingWidths widths) noexcept {
    constexpr double coarse = 0.25;  // pixels
    const double tolerance = settings.fitCurves > 0.0 ? settings.fitCurves : settings.simplify;
    return tolerance >= coarse && !isOutlined(settings, widths) ? 0.1 : 0.01;
}

LineLayers layersOf(const Lines& lines, const PictureSettings& picture, const LineSettings& settings,
                    VaryingWidths widths, glm::dvec2 origin) {
    PenPaths drawn;
    const double tolerance = std::max(settings.simplify - lines.tolerance, 0.0);  // what is left of it
    const auto add = isOutlined(settings, widths) ? addOutlines : addCentreLines;
    add(drawn, lines, picture, settings, tolerance);
    const auto allPens = settings::pens(picture);
    LineLayers result{{}, drawn.isCut};
    for (std::size_t i = drawn.paths.size(); i-- > 0;) {  // the first covers the others, and comes last
        if (drawn.paths[i].empty()) continue;
        result.layers.push_back(layerOf(i, allPens[i], std::move(drawn.paths[i]), settings, widths));
        result.layers.back().origin = origin;
    }
    return result;
}

std::map<std::uint32_t, std::string_view> objectNames(const SceneNames& names) {
    std::map<std::uint32_t, std::string_view> byId;
    for (const NamedInstance& instance : names.instances) byId.emplace(instance.id, instance.node);
    return byId;
}

Drawing drawingOf(const Lines& lines, const Settings& settings, std::string_view title, VaryingWidths widths) {
    expectDrawable(lines, settings);
    Drawing drawing;
    drawing.page = pageOf(settings, lines.size);
    drawing.title = validText(title);
    drawing.description =
        fmt::format("Line drawing of a 3D model, {} x {} pixels", lines.size.width, lines.size.height);
    drawing.metadata = metadataOf(lines, settings);
    PictureSettings picture = settings.picture;
    picture.dpi = drawing.page.dpi;
    drawing.background = picture.background;
    if (!lines.shade.empty()) drawing.images.push_back({&lines.shade, drawing.page.picture});
    LineLayers drawn = layersOf(lines, picture, settings.lines, widths, drawing.page.picture);
    drawing.layers = std::move(drawn.layers);
    if (drawn.isCut) drawing.window = lines.size;
    drawing.names = objectNames(lines.names);
    drawing.step = stepFor(settings.lines, widths);
    return drawing;
}

}  // namespace inkedge::io

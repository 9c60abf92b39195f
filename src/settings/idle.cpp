#include "settings/idle.h"

#include <algorithm>

#include "settings/lengths.h"
#include "settings/shades.h"

namespace inkedge::settings {
namespace {

using Why = std::string_view;

constexpr Why acts{};
constexpr Why forPictures = "it is for pictures";
constexpr Why noLinesInStyle = "this --style draws no lines";

bool anyPicture(const OutputKinds& kinds) { return kinds.pictures || kinds.exr; }
bool anyDrawing(const OutputKinds& kinds) { return kinds.vectors || kinds.dxf; }
bool anyLines(const OutputKinds& kinds) { return anyDrawing(kinds) || kinds.json; }

bool wants(const Settings& settings, Map map) { return std::ranges::find(settings.maps, map) != settings.maps.end(); }

bool styleDrawsLines(const RenderSettings& settings) {
    return settings.style.style != Style::Sumi && settings.style.style != Style::None;
}

// Whether light falls on what is drawn under the lines, or in the map of it.
bool isLit(const Settings& settings, const OutputKinds& kinds) {
    const Shade shade = anyPicture(kinds) ? drawnShade(settings) : settings.shade.shade;
    return (anyPicture(kinds) || kinds.vectors) && shade != Shade::None && shade != Shade::BaseColor;
}

// Whether a picture's lines are traced between pixels by the planes detector.
bool drawsPlanes(const Settings& settings) {
    return settings.detector.detector == Detector::Planes && styleDrawsLines(settings) && !drawsMeshLines(settings);
}

bool drawsLinesOf(const Settings& settings, Detector detector) {
    return settings.detector.detector == detector && styleDrawsLines(settings) && !drawsMeshLines(settings);
}

// Whether maps need the lines between pixels.
bool mapsTrace(const Settings& settings) {
    return wants(settings, Map::Types) || wants(settings, Map::Ids) ||
           (wants(settings, Map::Edges) && settings.detector.detector == Detector::Planes);
}

bool mapsGradients(const Settings& settings) {
    return wants(settings, Map::DepthEdges) || wants(settings, Map::NormalEdges) ||
           (wants(settings, Map::Edges) && settings.detector.detector == Detector::Classic);
}

// Whether lines, a style or maps are made of the normals that lights draw.
bool readsNormals(const Settings& settings) {
    return settings.style.style == Style::Sumi || mapsGradients(settings) || drawsLinesOf(settings, Detector::Classic);
}

bool varies(const LineSettings& lines) { return lines.strokeWidth != StrokeWidth::Constant || lines.strokeTaper > 0.0; }

bool findsMeshLines(const Settings& settings, const OutputKinds& kinds) {
    return (anyPicture(kinds) && drawsMeshLines(settings)) ||
           (anyLines(kinds) && settings.lines.from != LinesFrom::Image);
}

Why whyNoMeshLines(const Settings& settings) {
    if (settings.lines.from == LinesFrom::Image) return "it needs lines of the mesh, and --lines-from is image";
    if (!styleDrawsLines(settings)) return noLinesInStyle;
    return "it needs lines of the mesh, and this --detector finds lines between pixels; --lines-from object";
}

// Why a picture has no strokes, which have pens and types.
Why whyNoStrokes(const Settings& settings) {
    if (!styleDrawsLines(settings)) return noLinesInStyle;
    return "lines of this --detector have neither types nor widths";
}

bool drawsStrokes(const Settings& settings, const OutputKinds& kinds) {
    return anyPicture(kinds) && (drawsPlanes(settings) || drawsMeshLines(settings));
}

Why idlePenOfTypes(const Settings& settings, const OutputKinds& kinds) {
    if (anyDrawing(kinds) || drawsStrokes(settings, kinds) || settings.frame.crop) return acts;
    return anyPicture(kinds) ? whyNoStrokes(settings) : "lines in .json have no width";
}

}  // namespace

bool readsVertexNormals(const Settings& settings, const OutputKinds& kinds) noexcept {
    const bool ofMesh = findsMeshLines(settings, kinds) || !(settings.picture.lines & formLineTypes).empty();
    const bool ofSurface = readsNormals(settings) || wants(settings, Map::Normal) ||
                           drawsLinesOf(settings, Detector::SaitoTakahashi) || !settings.detector.functions.empty();
    return ofMesh || ofSurface || drawnShade(settings) != Shade::None || settings.style.style != Style::Ink;
}

bool needsMeshLines(const RenderSettings& settings) noexcept {
    const LineSettings& lines = settings.lines;
    const LineTypes types = settings.picture.lines;
    const bool isolines = lines.isolines != Isolines{} && types.contains(LineType::Isoparametric);
    const bool marked = types.contains(LineType::Marked) && !(standardLineTypes - types).empty();
    return lines.hidden != HiddenLines::None || lines.contour != Contour::Auto ||
           lines.contourFinder != ContourFinder::Every || lines.coincident != CoincidentLines::Merge || varies(lines) ||
           !lines.brush.empty() || lines.subdivideAdaptive > 0 || isolines || marked;
}

bool drawsMeshLines(const RenderSettings& settings) noexcept {
    if (!styleDrawsLines(settings)) return false;
    if (settings.lines.from != LinesFrom::Auto) return settings.lines.from == LinesFrom::Object;
    return settings.detector.detector == Detector::Planes && needsMeshLines(settings);
}

Why idleWithoutMeshLines(const Settings& settings, const OutputKinds& kinds) {
    return findsMeshLines(settings, kinds) ? acts : whyNoMeshLines(settings);
}

Why idleLinesFrom(const Settings& settings, const OutputKinds& kinds) {
    if (settings.lines.from == LinesFrom::Image || anyLines(kinds)) return acts;
    return styleDrawsLines(settings) ? acts : noLinesInStyle;
}

Why idleStroke(const Settings& settings, const OutputKinds& kinds) {
    if (kinds.vectors || (anyPicture(kinds) && drawsMeshLines(settings))) return acts;
    if (anyPicture(kinds)) return whyNoMeshLines(settings);
    return kinds.dxf ? "lines in .dxf are as wide as their pens" : "lines in .json have no width";
}

Why idleStrokeWidth(const Settings& settings, const OutputKinds& kinds) {
    const bool form = !(settings.picture.lines & formLineTypes).empty();
    if (settings.lines.strokeWidth == StrokeWidth::Strength && !form)
        return "strength is of lines of form, and --lines leaves them out";
    return idleStroke(settings, kinds);
}

Why idleIsolines(const Settings& settings, const OutputKinds& kinds) {
    if (!settings.picture.lines.contains(LineType::Isoparametric)) return "--lines leaves isoparametric lines out";
    return idleWithoutMeshLines(settings, kinds);
}

Why idleFormTypes(const Settings& settings, const OutputKinds& kinds, LineTypes types) {
    if ((settings.picture.lines & types).empty()) return "--lines leaves these lines of form out";
    return idleTypes(settings, kinds);
}

Why idleSimplify(const Settings& settings, const OutputKinds& kinds) {
    if (!anyLines(kinds)) return "it is for lines in .svg, .pdf, .dxf and .json";
    const bool curved = settings.lines.fitCurves > 0.0 && !(kinds.vectors && varies(settings.lines));
    return curved && !kinds.json ? "--fit-curves says how far curves may stray" : acts;
}

Why idleCentreLines(const Settings& settings, const OutputKinds& kinds) {
    if (!anyDrawing(kinds)) return "it is for lines in .svg, .pdf and .dxf";
    return varies(settings.lines) && !kinds.dxf ? "lines whose width varies are outlines of strokes" : acts;
}

Why idleLineColor(const Settings& settings, const OutputKinds& kinds) {
    const bool inks = settings.style.style != Style::None || !settings.detector.functions.empty();
    if (!inks && !anyDrawing(kinds)) return noLinesInStyle;
    return anyPicture(kinds) || anyDrawing(kinds) ? acts : "lines in .json have no colour";
}

Why idleBackground(const Settings&, const OutputKinds& kinds) {
    return anyPicture(kinds) || kinds.vectors ? acts : "lines in .dxf and .json have nothing behind them";
}

Why idleTypes(const Settings& settings, const OutputKinds& kinds) {
    if (anyLines(kinds) || drawsStrokes(settings, kinds)) return acts;
    return wants(settings, Map::Types) || mapsTrace(settings) ? acts : whyNoStrokes(settings);
}

Why idlePen(const Settings& settings, const OutputKinds& kinds) {
    if (anyPicture(kinds) && drawsLinesOf(settings, Detector::RaskarCohen)) return acts;
    return idlePenOfTypes(settings, kinds);
}

Why idleLineStyle(const Settings& settings, const OutputKinds& kinds) {
    const PictureSettings defaults;
    if (settings.picture.pens == defaults.pens && settings.lines.hidden == HiddenLines::None)
        return "hidden: is for --hidden dashed or solid";
    return idlePenOfTypes(settings, kinds);
}

Why idleDpi(const Settings& settings, const OutputKinds& kinds) {
    if (kinds.pictures || anyDrawing(kinds) || isSizedOnPaper(settings.frame)) return acts;
    return idlePen(settings, kinds).empty() && settings.picture.lineWidth.millimetres
               ? acts
               : "it is for what is in millimetres, and for .png, .tif, .svg, .pdf and .dxf";
}

Why idlePage(const Settings& settings, const OutputKinds& kinds) {
    const bool givesSize = settings.frame.scale && !settings.frame.size;
    return anyDrawing(kinds) || givesSize ? acts : "it is for .svg, .pdf and .dxf; --size takes millimetres";
}

Why idleSamples(const Settings& settings, const OutputKinds& kinds) {
    if (anyPicture(kinds) ? drawnShade(settings) != Shade::None : kinds.vectors && settings.shade.shade != Shade::None)
        return acts;
    if (anyLines(kinds)) {
        if (settings.lines.from == LinesFrom::Image) return acts;
        if (!anyPicture(kinds)) return "lines of the mesh are exact";
    }
    const bool samples = drawsPlanes(settings) || drawsLinesOf(settings, Detector::RaskarCohen) ||
                         mapsTrace(settings) || !settings.detector.functions.empty() ||
                         settings.style.style == Style::Hatch;
    if (samples) return acts;
    return drawsMeshLines(settings) ? "lines of the mesh are exact" : "it is for the planes detector";
}

Why idleDetector(const Settings& settings, const OutputKinds& kinds) {
    if (!anyPicture(kinds)) return settings.lines.from == LinesFrom::Image ? acts : "lines are taken from the mesh";
    if (wants(settings, Map::Edges)) return acts;
    if (!styleDrawsLines(settings)) return noLinesInStyle;
    return drawsMeshLines(settings) ? "lines are taken from the mesh" : acts;
}

Why idleGradients(const Settings& settings, const OutputKinds& kinds) {
    if (!anyPicture(kinds)) return forPictures;
    if (mapsGradients(settings) || drawsLinesOf(settings, Detector::Classic)) return acts;
    return "it is for --detector classic and maps of depth-edges and normal-edges";
}

Why idleLightSpace(const Settings& settings, const OutputKinds& kinds) {
    if (isLit(settings, kinds)) return acts;
    if (!anyPicture(kinds)) return forPictures;
    return readsNormals(settings) ? acts
                                  : "it is for edges of normals, --detector classic, --style sumi and lit --shade";
}

Why idleNormalSpace(const Settings& settings, const OutputKinds& kinds) {
    if (!anyPicture(kinds)) return forPictures;
    return wants(settings, Map::Normal) ? acts : "it is for maps of normals";
}

Why idleLights(const Settings& settings, const OutputKinds& kinds) {
    if (!anyPicture(kinds)) return forPictures;
    if (wants(settings, Map::Normal) || drawsLinesOf(settings, Detector::SaitoTakahashi)) return acts;
    return readsNormals(settings)
               ? acts
               : "it is for maps of normals and their edges, --detector classic or saito-takahashi and --style sumi";
}

Why idleShade(const Settings&, const OutputKinds& kinds) {
    return anyPicture(kinds) || kinds.vectors ? acts : "lines in .dxf and .json have nothing under them";
}

Why idleLight(const Settings& settings, const OutputKinds& kinds) {
    return isLit(settings, kinds) ? acts : "it is for --shade flat, gooch and light";
}

Why idleProfiles(const Settings& settings, const OutputKinds& kinds) {
    if (!anyPicture(kinds)) return forPictures;
    return drawsLinesOf(settings, Detector::SaitoTakahashi) ? acts : "it is for --detector saito-takahashi";
}

Why idleViewAngle(const Settings& settings, const OutputKinds&) {
    if (settings.camera.index) return "--camera-index has its own";
    return settings.camera.orthographicHeight ? "the view is orthographic" : acts;
}

Why idleHeight(const Settings& settings, const OutputKinds&) {
    return settings.camera.index ? "--camera-index has its own" : acts;
}

Why idleFraming(const Settings&, const OutputKinds& kinds) {
    return kinds.views > 1 ? acts : "it is for several --views";
}

Why idleUnit(const Settings& settings, const OutputKinds& kinds) {
    const bool ownSize = kinds.dxf && !settings.picture.page && !isSizedOnPaper(settings.frame);
    return settings.frame.scale || kinds.json || ownSize ? acts : "there is no --scale";
}

Why idleTime(const Settings& settings, const OutputKinds&) {
    return settings.load.animation.empty() ? "there is no --animation" : acts;
}

}  // namespace inkedge::settings

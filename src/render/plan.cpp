#include "render/plan.h"

#include <algorithm>

#include "lines/object_lines.h"
#include "render/needs_context.h"
#include "settings/idle.h"
#include "settings/shades.h"

namespace inkedge::render {
namespace {

LineSource sourceOf(const RenderSettings& settings, const StyleRow& style) {
    if (!style.drawsLines) return LineSource::None;
    if (settings::drawsMeshLines(settings)) return LineSource::Object;
    switch (settings.detector.detector) {
        case Detector::Planes:
            return LineSource::Planes;
        case Detector::Classic:
            return LineSource::Classic;
        case Detector::SaitoTakahashi:
            return LineSource::Profiles;
        case Detector::RaskarCohen:
            return LineSource::Fattened;
        case Detector::None:
            break;
    }
    return LineSource::None;
}

// The maps, and what has to be found for them and for the picture's lines.
void planLines(const RenderSettings& settings, Plan& plan) {
    const Detector detector = settings.detector.detector;
    const bool edges = wants(settings, Map::Edges);
    const bool ids = wants(settings, Map::Ids);
    plan.surfaceMaps = {wants(settings, Map::Depth), wants(settings, Map::Normal)};
    plan.edgeMaps = {wants(settings, Map::DepthEdges), wants(settings, Map::NormalEdges),
                     edges && detector == Detector::Classic};
    plan.types = wants(settings, Map::Types);
    plan.lineMask = edges && detector == Detector::Planes;
    plan.mapsBeside = (plan.types || plan.lineMask) && !(settings.picture.lines & lines::typesAddedToMaps).empty();
    plan.inkMask = edges;
    plan.ids = ids ? trace::TraceIds::Keep : trace::TraceIds::Drop;
    // All maps show what lies at the middle of each pixel, which is no sample's middle where there are several.
    const bool mapsOfLines = plan.types || ids || plan.lineMask;
    plan.planesOfPixels = mapsOfLines && settings.picture.supersampling > 1;
    plan.tracesLines = plan.lines == LineSource::Planes || (mapsOfLines && !plan.planesOfPixels);
    const bool magnitudes = plan.edgeMaps.depth || plan.edgeMaps.normal;
    plan.magnitudes = magnitudes ? passes::Magnitudes::Keep : passes::Magnitudes::Drop;
    plan.detectsEdges = plan.lines == LineSource::Classic || plan.edgeMaps.either || magnitudes;
}

// What that is found in.
void planGeometry(const RenderSettings& settings, Plan& plan) {
    const StyleRow& style = *plan.style;
    const int samples = settings.picture.supersampling;
    plan.planes = plan.tracesLines || style.planes;
    plan.surface = plan.detectsEdges || plan.lines == LineSource::Profiles || style.surface || plan.surfaceMaps.depth ||
                   plan.surfaceMaps.normal;
    plan.together = plan.surface && (plan.planesOfPixels || (plan.planes && samples == 1)) &&
                    settings.detector.normalLights == NormalLights::Single;
    plan.fattened = plan.lines == LineSource::Fattened;
    plan.functions = !settings.detector.functions.empty();
    if (style.reach != nullptr) plan.margin = std::max(raster::tileMargin, style.reach(settings.style) * samples);
}

}  // namespace

bool wants(const RenderSettings& settings, Map map) {
    return std::ranges::find(settings.maps, map) != settings.maps.end();
}

Plan planOf(const RenderSettings& settings) {
    Plan plan;
    plan.style = &styleRow(settings.style.style);
    plan.lines = sourceOf(settings, *plan.style);
    planLines(settings, plan);
    planGeometry(settings, plan);
    plan.shade = settings::drawnShade(settings);
    plan.underlaid = settings.shade.shade != Shade::None;
    if (plan.style->redraw != nullptr || plan.underlaid) plan.paper = settings::Paper::Transparent;
    return plan;
}

bool pictureNeedsContext(const RenderSettings& settings) { return planOf(settings).needsContext(); }

bool pictureNeedsRays(const RenderSettings& settings) { return planOf(settings).lines == LineSource::Object; }

bool linesNeedContext(const RenderSettings& settings) {
    return settings.lines.from == LinesFrom::Image || settings.shade.shade != Shade::None;
}

Plan planOfShade(const RenderSettings& settings) {
    Plan plan;
    plan.shade = settings.shade.shade;
    return plan;
}

Plan planOfImageLines() {
    Plan plan;
    plan.lines = LineSource::Planes;
    plan.planes = true;
    plan.tracesLines = true;
    return plan;
}

}  // namespace inkedge::render

#include "render/picture.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "gl/stage_clock.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "lines/lengths.h"
#include "passes/ink_over.h"
#include "render/lines.h"
#include "render/map_beside.h"
#include "render/plan.h"
#include "render/tiles.h"

namespace inkedge::render {

namespace {

LineLengths lengthsOf(std::span<const trace::TracedPiece> pieces, const Lines& ofMesh) {
    LineLengths lengths = lines::lengthsOf(ofMesh.lines);
    for (const trace::TracedPiece& piece : pieces)
        lengths[static_cast<std::size_t>(bitIndex(piece.type))] +=
            static_cast<double>(glm::distance(piece.ends[0], piece.ends[1]));
    return lengths;
}

}  // namespace

// From a scene and a camera to a picture, and to the maps that were asked for beside it.
Maps drawPicture(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    const Plan plan = planOf(settings);
    std::vector<StageTime> times;
    std::vector<ink::Stroke> strokes;
    const ink::Brush* brush = nullptr;
    Lines ofMesh;

    // Lines of the mesh itself are found without drawing a pixel.
    if (plan.lines == LineSource::Object) {
        brush = kept.brush(settings.lines.brush, scene.loadedWith().limits);
        ofMesh = objectLines(scene, camera, settings, kept);
        times = std::move(ofMesh.times);
        strokes = ink::strokesOf(ofMesh, settings.picture, settings.lines);
    }

    // All else is seen: the triangles are drawn tile by tile, and maps, lines between pixels and ink are found in them.
    Graphics* const graphics = plan.needsContext() ? &kept.graphics(times) : nullptr;
    std::optional<gl::Current> current;
    if (graphics != nullptr) current.emplace(graphics->context());
    gl::StageClock clock = graphics != nullptr ? gl::StageClock{graphics->gpu().api, times} : gl::StageClock{times};
    Tiles tiles;
    if (plan.drawsTiles()) {
        const passes::Frame frame = graphics->frame(scene, camera, settings.picture);
        clock.finish("upload");
        tiles = drawTiles(frame, graphics->inputs(), settings, plan, clock);
        if (plan.lines == LineSource::Planes) {
            strokes = ink::strokesOf(tiles.pieces);
            ofMesh = linesBesidePixels(scene, camera, settings, kept);
            const std::vector<ink::Stroke> beside = ink::strokesOf(ofMesh, settings.picture, {});
            strokes.insert(strokes.end(), beside.begin(), beside.end());
            if (!ofMesh.lines.empty()) clock.finish("lines of the mesh");
        } else if (plan.lines != LineSource::Object && plan.mapsBeside) {
            ofMesh = linesBesidePixels(scene, camera, settings, kept);
        }
        if (plan.mapsBeside) mapBeside(ofMesh, settings.picture.lines, tiles.maps);
    }

    // The lines are painted as strokes, and the other ink over them. The classic detector's are pixels already.
    Maps maps = std::move(tiles.maps);
    if (plan.lines == LineSource::Object || plan.lines == LineSource::Planes)
        maps.lengths = lengthsOf(tiles.pieces, ofMesh);
    if (plan.lines != LineSource::Classic) {
        maps.picture = ink::paintStrokes(strokes, settings.picture, brush, plan.paper);
        clock.finish("paint");
    }
    passes::inkOver(tiles.ink, settings.picture, maps.picture);
    if (plan.inkMask && (!tiles.ink.empty() || maps.edges.empty()))
        maps.edges = passes::darker(std::move(maps.edges), passes::maskOf(tiles.ink, settings.picture.size));

    // Some styles draw the picture anew.
    if (plan.style->redraw != nullptr) {
        maps.picture = plan.style->redraw(graphics->gpu(), maps.picture, settings);
        clock.finish(plan.style->stage);
    }
    if (plan.paper == settings::Paper::Transparent) {
        const Image<std::uint8_t> none;
        maps.picture =
            passes::onBackground(std::move(maps.picture), plan.underlaid ? maps.shade : none, settings.picture);
    }
    if (!wants(settings, Map::Shade)) maps.shade = {};

    if (graphics != nullptr) graphics->gpu().textures.trim();
    maps.camera = camera;
    maps.dpi = settings.picture.dpi;
    if (wants(settings, Map::Ids)) maps.names = namesOf(scene);
    maps.backend = kept.backend();
    maps.times = std::move(times);
    return maps;
}

}  // namespace inkedge::render

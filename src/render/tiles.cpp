#include "render/tiles.h"

#include <optional>
#include <utility>

#include "gl/read_back.h"
#include "lines/specks.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/detect_profiles.h"
#include "passes/function_edges.h"
#include "passes/ink_over.h"
#include "scene/prepared.h"
#include "trace/scraps.h"
#include "trace/screen_triangles.h"
#include "trace/thin_lines.h"
#include "trace/thin_parts.h"

namespace inkedge::render {
namespace {

class TilePainter {
public:
    TilePainter(const passes::Frame& picture, gl::FunctionInputs& inputs, const RenderSettings& settings,
                const Plan& plan, gl::StageClock& clock)
        : inputs_{inputs}, settings_{settings}, plan_{plan}, clock_{clock} {
        if (plan.tracesLines) {
            triangles_.emplace(picture.scene, picture.upload.firstTriangles(), picture.camera, picture.tile.whole);
            thinParts_ =
                trace::findThinParts(picture.scene, *triangles_, picture.tile.whole, settings.picture.supersampling);
            clock.finish("thin parts");
        }
        if (plan.style->tileInk != nullptr) {
            styleInk_ = plan.style->tileInk(picture.scene, settings);
            clock.finish(plan.style->stage);
        }
    }

    void draw(const TileFrames& tile, Tiles& all) {
        const raster::Tile& pixels = tile.pixels.tile;
        Maps maps;
        const Geometry geometry = drawGeometry(tile);
        if (geometry.planes && triangles_) traceTile(tile.samples, *geometry.planes, maps, all.pieces);
        if (geometry.surface) readTile(tile.pixels, *geometry.surface, maps);
        raster::keep(ink(tile, geometry), pixels, all.ink);
        raster::keep(std::move(maps), pixels, all.maps);
    }

private:
    Geometry drawGeometry(const TileFrames& tile) {
        Geometry geometry;
        if (plan_.together) {
            passes::PlanesAndSurface both = passes::drawPlanesAndSurface(tile.samples, settings_.detector.lightSpace);
            clock_.finish("geometry");
            return {std::move(both.planes), std::move(both.surface)};
        }
        if (plan_.planes) {
            geometry.planes = passes::drawPlanes(tile.samples);
            clock_.finish("planes");
        }
        if (plan_.surface) {
            geometry.surface = passes::drawSurface(tile.pixels, settings_.detector);
            clock_.finish("surface");
        }
        return geometry;
    }

    // The lines between planes, and their types and ids.
    void traceTile(const passes::Frame& frame, const passes::PlaneBuffers& buffers, Maps& maps,
                   std::vector<trace::TracedPiece>& pieces) {
        const PictureSettings& picture = settings_.picture;
        const gl::Api& api = frame.gpu.api;
        trace::LineBuffers lines;
        lines.tile = frame.tile;
        lines.marks = passes::detectLines(frame, buffers.planes, scene::minCreaseBend(frame.scene));
        clock_.finish("lines");
        const std::vector<raster::Rectangle> regions =
            plan_.ids == trace::TraceIds::Keep ? std::vector<raster::Rectangle>{{0, 0, lines.marks.size()}}
                                               : passes::regionsAround(trace::withThinParts(
                                                     lines.marks, thinParts_, lines.tile, picture.supersampling));
        lines.planes = gl::readFloats(api, buffers.planes, 4, regions);
        lines.triangles = gl::readIntegers(api, buffers.triangles, regions);
        clock_.finish("read-back");
        trace::TracedLines traced =
            trace::traceLines(std::move(lines), frame.scene, *triangles_, thinParts_, frame.camera, frame.unit,
                              trace::drawnTypes(picture), picture.supersampling, plan_.ids);
        pieces.insert(pieces.end(), traced.pieces.begin(), traced.pieces.end());
        if (plan_.lineMask) maps.edges = passes::mask(traced.types, picture.lines);
        if (plan_.types) maps.types = std::move(traced.types);
        maps.ids = std::move(traced.ids);
        clock_.finish("trace");
    }

    // Depth and normal maps, their edges and, if those are the picture's lines, the picture.
    void readTile(const passes::Frame& frame, const passes::SurfaceBuffers& buffers, Maps& maps) {
        passes::readSurface(frame.gpu.api, buffers, plan_.surfaceMaps, maps);
        if (plan_.detectsEdges) {
            const passes::EdgeBuffers edges =
                passes::detectEdges(frame.gpu, buffers.surface, frame.camera, settings_.detector, plan_.magnitudes);
            clock_.finish("edges");
            if (plan_.lines == LineSource::Classic) {
                maps.picture =
                    passes::composite(passes::readMarks(frame.gpu.api, edges), settings_.picture, plan_.paper);
                clock_.finish("composite");
            }
            passes::readEdges(frame.gpu.api, edges, plan_.edgeMaps, maps);
        }
        clock_.finish("read-back");
    }

    // What covers pixels besides strokes: edges of functions, profiles, and what the style adds.
    Image<std::uint8_t> ink(const TileFrames& tile, const Geometry& geometry) {
        const DetectorSettings& detector = settings_.detector;
        Image<std::uint8_t> ink;
        if (plan_.functions) {
            ink = passes::functionEdges(tile.samples, inputs_, detector.functions, settings_.picture.supersampling);
            clock_.finish("functions");
        }
        if (plan_.lines == LineSource::Profiles) {
            ink = passes::darker(std::move(ink),
                                 passes::detectProfiles(tile.pixels, geometry.surface->surface, detector));
            clock_.finish("profiles");
        }
        if (styleInk_) {
            ink = passes::darker(std::move(ink), styleInk_(tile, geometry));
            clock_.finish(plan_.style->stage);
        }
        return ink;
    }

    gl::FunctionInputs& inputs_;
    const RenderSettings& settings_;
    const Plan& plan_;
    gl::StageClock& clock_;
    std::optional<trace::ScreenTriangles> triangles_;
    std::vector<trace::ThinStretch> thinParts_;
    TileInk styleInk_;
};

}  // namespace

Tiles drawTiles(const passes::Frame& picture, gl::FunctionInputs& inputs, const RenderSettings& settings,
                const Plan& plan, gl::StageClock& clock) {
    Tiles all;
    TilePainter painter{picture, inputs, settings, plan, clock};
    for (const raster::Tile& tile : raster::tilesOf(picture.tile.whole, settings.picture.tileSize, plan.margin)) {
        const passes::Frame samples = passes::withTile(picture, tile);
        painter.draw({samples, passes::inPixels(samples, settings.picture.supersampling)}, all);
    }
    if (lines::leavesOutScraps(picture.scene)) trace::leaveOutScraps(all.pieces);
    return all;
}

}  // namespace inkedge::render

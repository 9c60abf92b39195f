#include "render/tiles.h"

#include <optional>
#include <utility>

#include "gl/read_back.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/detect_profiles.h"
#include "passes/function_edges.h"
#include "passes/ink_over.h"
#include "trace/screen_triangles.h"

namespace inkedge {
namespace {

class TilePainter {
public:
    TilePainter(const Frame& picture, gl::FunctionInputs& inputs, const RenderSettings& settings, const Plan& plan,
                gl::StageClock& clock)
        : inputs_{inputs}, settings_{settings}, plan_{plan}, clock_{clock} {
        if (plan.tracesLines) {
            triangles_.emplace(picture.scene, picture.upload.firstTriangles(), picture.camera, picture.tile.whole);
        }
        if (plan.style->tileInk != nullptr) {
            styleInk_ = plan.style->tileInk(picture.scene, settings);
            clock.finish(plan.style->stage);
        }
    }

    void draw(const TileFrames& tile, Tiles& all) {
        const Tile& pixels = tile.pixels.tile;
        Maps maps;
        const Geometry geometry = drawGeometry(tile);
        if (geometry.planes && triangles_) traceTile(tile.samples, *geometry.planes, maps, all.pieces);
        if (geometry.surface) readTile(tile.pixels, *geometry.surface, maps);
        keep(ink(tile, geometry), pixels, all.ink);
        keep(std::move(maps), pixels, all.maps);
    }

private:
    Geometry drawGeometry(const TileFrames& tile) {
        Geometry geometry;
        if (plan_.together) {
            PlanesAndSurface both = drawPlanesAndSurface(tile.samples, settings_.detector.lightSpace);
            clock_.finish("geometry");
            return {std::move(both.planes), std::move(both.surface)};
        }
        if (plan_.planes) {
            geometry.planes = drawPlanes(tile.samples);
            clock_.finish("planes");
        }
        if (plan_.surface) {
            geometry.surface = drawSurface(tile.pixels, settings_.detector);
            clock_.finish("surface");
        }
        return geometry;
    }

    // The lines between planes, and their types and ids.
    void traceTile(const Frame& frame, const PlaneBuffers& buffers, Maps& maps, std::vector<TracedPiece>& pieces) {
        const PictureSettings& picture = settings_.picture;
        const gl::Api& api = frame.gpu.api;
        LineBuffers lines;
        lines.tile = frame.tile;
        lines.marks = detectLines(frame, buffers.planes, frame.scene.creaseAngle());
        clock_.finish("lines");
        const std::vector<Rectangle> regions =
            plan_.ids == TraceIds::Keep ? std::vector<Rectangle>{{0, 0, lines.marks.size}} : regionsAround(lines.marks);
        lines.planes = gl::readFloats(api, buffers.planes, 4, regions);
        lines.triangles = gl::readIntegers(api, buffers.triangles, regions);
        clock_.finish("read-back");
        TracedLines traced = traceLines(std::move(lines), frame.scene, *triangles_, frame.camera, frame.unit,
                                        drawnTypes(picture), picture.supersampling, plan_.ids);
        pieces.insert(pieces.end(), traced.pieces.begin(), traced.pieces.end());
        if (plan_.lineMask) maps.edges = mask(traced.types, picture.lines);
        if (plan_.types) maps.types = std::move(traced.types);
        maps.ids = std::move(traced.ids);
        clock_.finish("trace");
    }

    // Depth and normal maps, their edges and, if those are the picture's lines, the picture.
    void readTile(const Frame& frame, const SurfaceBuffers& buffers, Maps& maps) {
        readSurface(frame.gpu.api, buffers, plan_.surfaceMaps, maps);
        if (plan_.detectsEdges) {
            const EdgeBuffers edges =
                detectEdges(frame.gpu, buffers.surface, frame.camera, settings_.detector, plan_.magnitudes);
            clock_.finish("edges");
            if (plan_.lines == LineSource::Classic) {
                maps.picture = composite(readMarks(frame.gpu.api, edges), settings_.picture, plan_.paper);
                clock_.finish("composite");
            }
            readEdges(frame.gpu.api, edges, plan_.edgeMaps, maps);
        }
        clock_.finish("read-back");
    }

    // What covers pixels besides strokes: edges of functions, profiles, and what the style adds.
    Image<std::uint8_t> ink(const TileFrames& tile, const Geometry& geometry) {
        const DetectorSettings& detector = settings_.detector;
        Image<std::uint8_t> ink;
        if (plan_.functions) {
            ink = functionEdges(tile.samples, inputs_, detector.functions, settings_.picture.supersampling);
            clock_.finish("functions");
        }
        if (plan_.lines == LineSource::Profiles) {
            ink = darker(std::move(ink), detectProfiles(tile.pixels, geometry.surface->surface, detector));
            clock_.finish("profiles");
        }
        if (styleInk_) {
            ink = darker(std::move(ink), styleInk_(tile, geometry));
            clock_.finish(plan_.style->stage);
        }
        return ink;
    }

    gl::FunctionInputs& inputs_;
    const RenderSettings& settings_;
    const Plan& plan_;
    gl::StageClock& clock_;
    std::optional<ScreenTriangles> triangles_;
    TileInk styleInk_;
};

}  // namespace

Tiles drawTiles(const Frame& picture, gl::FunctionInputs& inputs, const RenderSettings& settings, const Plan& plan,
                gl::StageClock& clock) {
    Tiles all;
    TilePainter painter{picture, inputs, settings, plan, clock};
    for (const Tile& tile : tilesOf(picture.tile.whole, settings.picture.tileSize, plan.margin)) {
        const Frame samples = withTile(picture, tile);
        painter.draw({samples, inPixels(samples, settings.picture.supersampling)}, all);
    }
    return all;
}

}  // namespace inkedge

#include "render/tiles.h"

#include <optional>
#include <span>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "base/later.h"
#include "camera/light.h"
#include "gl/read_back.h"
#include "lines/specks.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/detect_profiles.h"
#include "passes/draw_fattened.h"
#include "passes/draw_shade.h"
#include "passes/function_edges.h"
#include "passes/ink_over.h"
#include "scene/prepared.h"
#include "settings/lengths.h"
#include "trace/scraps.h"
#include "trace/screen_triangles.h"
#include "trace/thin_lines.h"
#include "trace/thin_parts.h"

namespace inkedge::render {
namespace {

// What lines are traced of, beside the planes of a tile: in samples or pixels of the whole picture.
struct Traceable {
    trace::ScreenTriangles triangles;
    std::vector<trace::ThinStretch> thinParts;
};

// Of large scenes it is made while the triangles are drawn.
base::Later<Traceable> traceable(const passes::Frame& picture, Size whole, int samplesPerPixel) {
    const auto make = [&picture, whole, samplesPerPixel] {
        trace::ScreenTriangles triangles{picture.scene, picture.upload.firstTriangles(), picture.camera, whole};
        std::vector<trace::ThinStretch> thin = trace::findThinParts(picture.scene, triangles, whole, samplesPerPixel);
        return Traceable{std::move(triangles), std::move(thin)};
    };
    return {make, picture.scene.triangleCount()};
}

class TilePainter {
public:
    TilePainter(const passes::Frame& picture, gl::FunctionInputs& inputs, const RenderSettings& settings,
                const Plan& plan, gl::StageClock& clock)
        : inputs_{inputs}, settings_{settings}, plan_{plan}, clock_{clock} {
        if (plan.tracesLines) samples_.emplace(traceable(picture, picture.tile.whole, settings.picture.supersampling));
        if (plan.planesOfPixels) pixels_.emplace(traceable(picture, settings.picture.size, 1));
        if (plan.style->tileInk != nullptr) {
            styleInk_ = plan.style->tileInk(picture.scene, settings);
            clock.finish(plan.style->stage);
        }
    }

    void draw(const TileFrames& tile, Tiles& all) {
        const raster::Tile& pixels = tile.pixels.tile;
        Maps maps;
        const Geometry geometry = drawGeometry(tile);
        if (geometry.planesOfPixels) keepMaps(traced(tile.pixels, *geometry.planesOfPixels, *pixels_, 1), maps);
        if (geometry.planes && samples_) {
            trace::TracedLines lines =
                traced(tile.samples, *geometry.planes, *samples_, settings_.picture.supersampling);
            all.pieces.insert(all.pieces.end(), lines.pieces.begin(), lines.pieces.end());
            if (!plan_.planesOfPixels) keepMaps(std::move(lines), maps);
        }
        if (geometry.surface) readTile(tile.pixels, *geometry.surface, maps);
        if (plan_.shade != Shade::None) maps.shade = shade(tile.samples);
        raster::keep(ink(tile, geometry), pixels, all.ink);
        raster::keep(std::move(maps), pixels, all.maps);
    }

private:
    Geometry drawGeometry(const TileFrames& tile) {
        Geometry geometry;
        std::optional<passes::PlaneBuffers>& ofMaps = plan_.planesOfPixels ? geometry.planesOfPixels : geometry.planes;
        if (plan_.together) {
            passes::PlanesAndSurface both = passes::drawPlanesAndSurface(tile.pixels, settings_.detector.lightSpace);
            ofMaps = std::move(both.planes);
            geometry.surface = std::move(both.surface);
            clock_.finish("geometry");
        } else if (plan_.planesOfPixels) {
            ofMaps = passes::drawPlanes(tile.pixels);
            clock_.finish("planes");
        }
        if (plan_.planes && !geometry.planes) {
            geometry.planes = passes::drawPlanes(tile.samples);
            clock_.finish("planes");
        }
        if (plan_.surface && !geometry.surface) {
            geometry.surface = passes::drawSurface(tile.pixels, settings_.detector);
            clock_.finish("surface");
        }
        return geometry;
    }

    // The lines between planes of samples, or of pixels for maps alone.
    trace::TracedLines traced(const passes::Frame& frame, const passes::PlaneBuffers& buffers,
                              base::Later<Traceable>& later, int samplesPerPixel) {
        const gl::Api& api = frame.gpu.api;
        const trace::TraceIds ids = samplesPerPixel == 1 ? plan_.ids : trace::TraceIds::Drop;
        trace::LineBuffers lines;
        lines.tile = frame.tile;
        lines.marks = passes::detectLines(frame, buffers.planes, scene::minCreaseBend(frame.scene));
        clock_.finish("lines");
        const Traceable& onPlanes = later.get();
        clock_.finish("thin parts");
        const std::vector<raster::Rectangle> regions = passes::regionsAround(
            trace::withThinParts(lines.marks, onPlanes.thinParts, lines.tile, samplesPerPixel));
        const std::vector<raster::Rectangle> whole{{0, 0, lines.marks.size()}};
        lines.planes = gl::readFloats(api, buffers.planes, 4, regions);
        lines.triangles = gl::readIntegers(api, buffers.triangles, ids == trace::TraceIds::Keep ? whole : regions);
        clock_.finish("read-back");
        trace::TracedLines traced =
            trace::traceLines(std::move(lines), frame.scene, onPlanes.triangles, onPlanes.thinParts, frame.camera,
                              frame.unit, trace::drawnTypes(settings_.picture), samplesPerPixel, ids);
        clock_.finish("trace");
        return traced;
    }

    void keepMaps(trace::TracedLines lines, Maps& maps) const {
        if (plan_.lineMask) maps.edges = passes::mask(lines.types, settings_.picture.lines);
        if (plan_.types) maps.types = std::move(lines.types);
        maps.ids = std::move(lines.ids);
    }

    // Depth and normal maps, their edges and, if those are the picture's lines, the picture.
    void readTile(const passes::Frame& frame, const passes::SurfaceBuffers& buffers, Maps& maps) {
        passes::readSurface(frame.gpu.api, buffers, plan_.surfaceMaps, maps);
        turnNormals(frame.camera, maps.normal);
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

    // From the axes of the lights to those that are asked for.
    void turnNormals(const Camera& camera, Image<float>& normals) const {
        const bool fromWorld = settings_.detector.lightSpace == LightSpace::World;
        if (fromWorld == (settings_.normalSpace == NormalSpace::World)) return;
        const glm::mat3 view{camera.view};
        const glm::mat3 turn = fromWorld ? view : glm::transpose(view);
        const std::span<float> values = normals.mutablePixels();
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const glm::vec3 turned = turn * glm::vec3{values[i], values[i + 1], values[i + 2]};
            for (std::size_t k = 0; k < 3; ++k) values[i + k] = turned[static_cast<int>(k)];
        }
    }

    Image<std::uint8_t> fattened(const passes::Frame& frame) {
        const PictureSettings& picture = settings_.picture;
        const double width = picture.supersampling * settings::pixelsOf(picture.lineWidth, picture.pixelsPerInch());
        return passes::meanOf(passes::drawFattened(frame, inputs_, width), picture.supersampling);
    }

    Image<std::uint8_t> shade(const passes::Frame& frame) {
        const glm::dvec3 light =
            camera::towardsLight(frame.scene, frame.camera, settings_.shade.light, settings_.detector.lightSpace);
        Image<std::uint8_t> colors =
            passes::drawShade(frame, inputs_, plan_.shade, light, settings_.picture.supersampling);
        clock_.finish("shade");
        return colors;
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
        if (plan_.fattened) {
            ink = passes::darker(std::move(ink), fattened(tile.samples));
            clock_.finish("fattened faces");
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
    std::optional<base::Later<Traceable>> samples_;
    std::optional<base::Later<Traceable>> pixels_;  // of Plan::planesOfPixels
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

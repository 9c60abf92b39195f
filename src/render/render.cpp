#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <inkedge/renderer.h>
#include <inkedge/setting_table.h>

#include "gl/context.h"
#include "gl/function_inputs.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/stage_clock.h"
#include "gl/upload.h"
#include "ink/brush.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "lines/join_pieces.h"
#include "lines/object_lines.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/detect_profiles.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/function_edges.h"
#include "passes/hatch.h"
#include "passes/ink_over.h"
#include "passes/pencil.h"
#include "passes/placement.h"
#include "passes/read_maps.h"
#include "passes/sumi.h"
#include "raster/tiles.h"
#include "render/expect_usable.h"
#include "scene/typical_bend.h"
#include "trace/screen_triangles.h"
#include "trace/trace_lines.h"

namespace inkedge {
namespace {

// What one call draws.
struct View {
    gl::Gpu& gpu;
    const gl::UploadedScene& upload;
    gl::FunctionInputs& inputs;
    const Scene& scene;
    const Camera& camera;
    const RenderSettings& settings;
};

// Where the picture's lines come from.
enum class Source { Planes, Classic, Profiles, Object, None };
Source sourceOf(const RenderSettings& settings) {
    if (settings.style.style == Style::Sumi) return Source::None;
    if (settings.lines.from == LinesFrom::Object) return Source::Object;
    switch (settings.detector.detector) {
        case Detector::Planes:
            return Source::Planes;
        case Detector::Classic:
            return Source::Classic;
        case Detector::SaitoTakahashi:
            return Source::Profiles;
        case Detector::None:
            break;
    }
    return Source::None;
}

bool findsPlaneLines(const RenderSettings& settings) { return settings.detector.detector == Detector::Planes; }
bool findsClassicEdges(const RenderSettings& settings) { return settings.detector.detector == Detector::Classic; }
bool drawsFunctions(const RenderSettings& settings) { return !settings.detector.functions.empty(); }

bool needsPlaneLines(const RenderSettings& settings) {
    return sourceOf(settings) == Source::Planes || wantsAny(settings, {Map::Types, Map::Ids}) ||
           (findsPlaneLines(settings) && wants(settings, Map::Edges));
}

bool needsPlanes(const RenderSettings& settings) {
    return needsPlaneLines(settings) || settings.style.style == Style::Hatch;
}

bool needsSurface(const RenderSettings& settings) {
    return sourceOf(settings) == Source::Classic || (findsClassicEdges(settings) && wants(settings, Map::Edges)) ||
           sourceOf(settings) == Source::Profiles || settings.style.style == Style::Sumi ||
           wantsAny(settings, {Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges});
}

bool drawsTriangles(const RenderSettings& settings) {
    return needsPlanes(settings) || needsSurface(settings) || drawsFunctions(settings);
}

// Lines from object space, and pictures of nothing else, need none.
bool needsContext(const RenderSettings& settings) {
    return drawsTriangles(settings) || settings.style.style == Style::Pencil;
}

Size samplesOf(const PictureSettings& picture) {
    return {picture.size.width * picture.supersampling, picture.size.height * picture.supersampling};
}

// What the triangles are drawn into.
struct Geometry {
    std::optional<PlaneBuffers> planes;
    std::optional<SurfaceBuffers> surface;
};

// In one pass where both are wanted, of one size and with lights that need one pass only.
Geometry drawGeometry(const View& view, const Tile& tile, gl::StageClock& clock) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    const int samples = settings.picture.supersampling;
    const bool planes = needsPlanes(settings);
    const bool surface = needsSurface(settings);
    Geometry geometry;
    if (planes && surface && samples == 1 && settings.detector.normalLights == NormalLights::Single) {
        PlanesAndSurface both = drawPlanesAndSurface(gpu, upload, scene, camera, settings.detector.lightSpace, tile);
        clock.finish("geometry");
        return {std::move(both.planes), std::move(both.surface)};
    }
    if (planes) {
        geometry.planes = drawPlanes(gpu, upload, scene, camera, tile);
        clock.finish("planes");
    }
    if (surface) {
        geometry.surface = drawSurface(gpu, upload, scene, camera, settings.detector, inPixels(tile, samples));
        clock.finish("surface");
    }
    return geometry;
}

// Depth and normal maps, their edges, and, for the classic detector, the picture.
void renderSurface(const View& view, const SurfaceBuffers& surface, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    const bool keepMagnitudes = wantsAny(settings, {Map::DepthEdges, Map::NormalEdges});
    readSurface(gpu.api, surface, settings, maps);
    if (findsClassicEdges(settings) || keepMagnitudes) {
        const EdgeBuffers edges = detectEdges(gpu, surface.surface, camera, settings.detector,
                                              keepMagnitudes ? Magnitudes::Keep : Magnitudes::Drop);
        clock.finish("edges");
        if (sourceOf(settings) == Source::Classic) {
            maps.picture = composite(readMarks(gpu.api, edges), settings.picture);
            clock.finish("composite");
        }
        readEdges(gpu.api, edges, settings, maps);
    }
    clock.finish("read-back");
}

// Lines of the planes detector: their types and ids into the maps; the strokes are left.
TracedLines renderPlanes(const View& view, const Tile& tile, const PlaneBuffers& buffers,
                         const ScreenTriangles& triangles, TracePlaces places, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const double unit = unitLength(scene);

    LineBuffers lines;
    lines.tile = tile;
    lines.marks = detectLines(gpu, buffers.planes, tile, camera, unit, scene.creaseAngle());
    clock.finish("lines");
    const bool keepIds = wants(settings, Map::Ids);
    const std::vector<Rectangle> regions =
        keepIds ? std::vector<Rectangle>{{0, 0, lines.marks.size}} : regionsAround(lines.marks);
    lines.planes = gl::readFloats(gpu.api, buffers.planes, 4, regions);
    lines.triangles = gl::readIntegers(gpu.api, buffers.triangles, regions);
    clock.finish("read-back");
    TracedLines traced = traceLines(std::move(lines), scene, triangles, camera, unit, drawnTypes(picture),
                                    picture.supersampling, keepIds ? TraceIds::Keep : TraceIds::Drop, places);
    if (findsPlaneLines(settings) && wants(settings, Map::Edges)) maps.edges = mask(traced.types, picture.lines);
    maps.ids = std::move(traced.ids);
    if (wants(settings, Map::Types)) maps.types = std::move(traced.types);
    clock.finish("trace");
    return traced;
}

// What covers a tile's pixels besides strokes: functions' edges, profiles, and what styles add.
Image<std::uint8_t> renderInk(const View& view, const Tile& tile, const Geometry& geometry, gl::StageClock& clock) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    const int samples = settings.picture.supersampling;
    Image<std::uint8_t> ink;
    if (drawsFunctions(settings)) {
        ink = functionEdges(gpu, upload, inputs, scene, camera, settings.detector.functions, tile, samples);
        clock.finish("functions");
    }
    if (sourceOf(settings) == Source::Profiles) {
        const Tile pixels = inPixels(tile, samples);
        ink = darker(std::move(ink), detectProfiles(gpu, geometry.surface->surface, camera, settings.detector, pixels));
        clock.finish("profiles");
    }
    if (settings.style.style == Style::Hatch) {
        ink =
            darker(std::move(ink),
                   meanOf(hatch(gpu, geometry.planes->planes, tile, camera, unitLength(scene), settings.style, samples),
                          samples));
        clock.finish("hatch");
    }
    if (settings.style.style == Style::Sumi) {
        ink = darker(std::move(ink), sumi(gpu, geometry.surface->surface, camera, settings.style));
        clock.finish("sumi");
    }
    return ink;
}

// What is drawn on the picture.
struct Ink {
    TracedLines traced;         // of the planes detector; nothing but strokes and places
    Image<std::uint8_t> cover;  // how much of each pixel is covered besides, 0 to 255; empty: none
};

// Samples around a tile that its passes need.
int reachOf(const RenderSettings& settings) {
    if (settings.style.style != Style::Sumi) return tileMargin;
    return std::max(tileMargin, sumiReach(settings.style) * settings.picture.supersampling);
}

// Draws tile by tile. Strokes reach over tiles' borders: they are painted when all are there.
Ink renderTiles(const View& view, TracePlaces places, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const Size samples = samplesOf(picture);
    std::optional<ScreenTriangles> triangles;
    if (needsPlaneLines(settings)) triangles.emplace(scene, upload.firstTriangles(), camera, samples);
    Ink ink;
    TracedLines& traced = ink.traced;
    for (const Tile& tile : tilesOf(samples, picture.tileSize, reachOf(settings))) {
        Maps part;
        const Geometry geometry = drawGeometry(view, tile, clock);
        if (triangles) {
            const TracedLines more = renderPlanes(view, tile, *geometry.planes, *triangles, places, clock, part);
            traced.strokes.insert(traced.strokes.end(), more.strokes.begin(), more.strokes.end());
            traced.places.insert(traced.places.end(), more.places.begin(), more.places.end());
        }
        if (geometry.surface) renderSurface(view, *geometry.surface, clock, part);
        keep(renderInk(view, tile, geometry, clock), inPixels(tile, picture.supersampling), ink.cover);
        keep(std::move(part), inPixels(tile, picture.supersampling), maps);
    }
    return ink;
}

// The lines that the planes detector finds between pixels, as polylines.
std::vector<Line> traceImageLines(const View& view, gl::StageClock& clock) {
    const auto& [gpu, upload, inputs, scene, camera, settings] = view;
    if (!findsPlaneLines(settings)) {
        throw Error{Error::Kind::Usage,
                    "lines from image: expected the planes detector, found another, which marks pixels and leaves no "
                    "lines; use --detector planes, or --lines-from object"};
    }
    RenderSettings linesOnly = settings;
    linesOnly.maps.clear();
    linesOnly.detector.functions.clear();
    linesOnly.style.style = Style::Ink;
    Maps none;
    const TracedLines traced =
        renderTiles({gpu, upload, inputs, scene, camera, linesOnly}, TracePlaces::Keep, clock, none).traced;
    const lines::Screen screen{camera, scene.bounds().centre, settings.picture.size};
    std::vector<lines::TracedPiece> pieces;
    pieces.reserve(traced.strokes.size());
    for (std::size_t i = 0; i < traced.strokes.size(); ++i) {
        const Stroke& stroke = traced.strokes[i];
        const StrokePlace& place = traced.places[i];
        const auto after = std::ranges::upper_bound(upload.firstTriangles(), place.triangle - 1);
        const auto instance = static_cast<std::uint32_t>(after - upload.firstTriangles().begin()) - 1;
        pieces.push_back({{stroke.from, stroke.to},
                          {double{place.nearnessFrom}, double{place.nearnessTo}},
                          static_cast<LineType>(1U << stroke.style),
                          {instance, place.triangle - 1 - upload.firstTriangles()[instance]}});
    }
    return lines::joinPieces(pieces, scene, screen);
}

// What the passes are asked for: what the scene decides is filled in, and what a pencil draws over lies on nothing.
RenderSettings completed(RenderSettings settings, const Scene& scene) {
    if (settings.style.style == Style::Hatch && !settings.style.hatchBend)
        settings.style.hatchBend = typicalBend(scene);
    if (settings.style.style == Style::Pencil) settings.picture.background.reset();
    return settings;
}

}  // namespace

// A context and what is kept in it.
struct Renderer::Graphics {
    explicit Graphics(const BackendSettings& wish) : context{gl::createContext(wish)} {
        const gl::Current current{*context};
        gpu = std::make_unique<gl::Gpu>(context->api());
        inputs = std::make_unique<gl::FunctionInputs>(context->api());
    }
    ~Graphics() {
        const gl::Current current{*context};
        inputs.reset();
        upload.reset();
        gpu.reset();
    }
    Graphics(const Graphics&) = delete;
    Graphics& operator=(const Graphics&) = delete;

    const gl::UploadedScene& uploaded(const Scene& scene) {
        if (!upload || !upload->holds(scene)) {
            upload.reset();  // first: never two scenes in graphics memory
            upload = std::make_unique<gl::UploadedScene>(gpu->api, scene);
        }
        return *upload;
    }

    std::unique_ptr<gl::Context> context;
    std::unique_ptr<gl::Gpu> gpu;
    std::unique_ptr<gl::UploadedScene> upload;
    std::unique_ptr<gl::FunctionInputs> inputs;
};

struct Renderer::State {
    explicit State(BackendSettings settings) : wish{std::move(settings)} {}

    // Made now if it is not there yet; what that took goes into the times.
    Graphics& graphics(std::vector<StageTime>& times) {
        if (!made) {
            gl::StageClock clock{times};
            made.emplace(wish);
            clock.finish("context");
        }
        return *made;
    }

    const lines::ObjectLines& prepared(const Scene& scene) {
        if (!objectLines || !objectLines->holds(scene)) {
            objectLines.reset();
            objectLines = std::make_unique<lines::ObjectLines>(scene);
        }
        return *objectLines;
    }

    // Read once; another file of the same name is not looked for.
    const Brush* brushFrom(const std::filesystem::path& file, const LoadLimits& limits) {
        if (file.empty()) return nullptr;
        if (!brush || file != brushFile) {
            brush = readBrush(file, limits);
            brushFile = file;
        }
        return &*brush;
    }

    BackendSettings wish;
    std::optional<Graphics> made;
    std::optional<Brush> brush;
    std::filesystem::path brushFile;
    std::unique_ptr<lines::ObjectLines> objectLines;
};

Renderer::Renderer(const BackendSettings& wish, ContextTime when) : state_{std::make_unique<State>(wish)} {
    validate(wish);
    std::vector<StageTime> untold;
    if (when == ContextTime::AtOnce) (void)state_->graphics(untold);
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

const BackendInfo& Renderer::backend() const noexcept {
    static const BackendInfo none;
    return state_->made ? state_->made->context->info() : none;
}

Lines Renderer::lines(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
    validate(settings);
    expectLoaded(scene, settings);
    expectUsable(camera);
    Lines found;
    std::vector<StageTime> before;
    if (settings.lines.from == LinesFrom::Image) {
        Graphics& graphics = state_->graphics(before);
        const gl::Current current{*graphics.context};
        gl::StageClock clock{graphics.gpu->api, before};
        const View view{*graphics.gpu, graphics.uploaded(scene), *graphics.inputs, scene, camera, settings};
        clock.finish("upload");
        found.lines = traceImageLines(view, clock);
        clock.finish("join");
        graphics.gpu->textures.trim();
        found.size = settings.picture.size;
        found.camera = camera;
        found.backend = backend();
        found.times = std::move(before);
        return found;
    }
    gl::StageClock preparing{before};
    const lines::ObjectLines& prepared = state_->prepared(scene);
    preparing.finish("prepare lines");
    found = prepared.find(camera, settings);
    found.backend = backend();
    found.times.insert(found.times.begin(), before.begin(), before.end());
    return found;
}

Maps Renderer::render(const Scene& scene, const Camera& camera, const RenderSettings& asked) {
    validate(asked);
    expectLoaded(scene, asked);
    expectUsable(camera);
    expectMemory(asked);
    const RenderSettings settings = completed(asked, scene);
    Maps maps;
    maps.camera = camera;
    Ink ink;
    std::vector<Stroke> strokes;
    const Brush* brush = nullptr;
    if (sourceOf(settings) == Source::Object) {
        brush = state_->brushFrom(settings.lines.brush, scene.loadedWith().limits);
        const Lines found = lines(scene, camera, settings);
        maps.times = found.times;
        strokes = strokesOf(found, settings.picture, settings.lines);
    }
    Graphics* const graphics = needsContext(settings) ? &state_->graphics(maps.times) : nullptr;
    maps.backend = backend();
    std::optional<gl::Current> current;
    if (graphics != nullptr) current.emplace(*graphics->context);
    gl::StageClock clock =
        graphics != nullptr ? gl::StageClock{graphics->gpu->api, maps.times} : gl::StageClock{maps.times};
    if (drawsTriangles(settings)) {
        const View view{*graphics->gpu, graphics->uploaded(scene), *graphics->inputs, scene, camera, settings};
        clock.finish("upload");
        ink = renderTiles(view, TracePlaces::Drop, clock, maps);
        if (sourceOf(settings) == Source::Planes) strokes = std::move(ink.traced.strokes);
    }
    if (sourceOf(settings) != Source::Classic) {
        maps.picture = paintStrokes(strokes, settings.picture, brush);
        clock.finish("paint");
    }
    inkOver(ink.cover, settings.picture, maps.picture);
    if (wants(settings, Map::Edges) && (!ink.cover.empty() || maps.edges.empty()))
        maps.edges = darker(std::move(maps.edges), maskOf(ink.cover, settings.picture.size));
    if (settings.style.style == Style::Pencil) {
        maps.picture = onBackground(pencil(*graphics->gpu, maps.picture, settings.style, settings.picture.tileSize),
                                    asked.picture);
        clock.finish("pencil");
    }
    if (graphics != nullptr) graphics->gpu->textures.trim();
    return maps;
}

}  // namespace inkedge

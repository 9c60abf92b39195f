#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <inkedge/renderer.h>

#include "gl/context.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/stage_clock.h"
#include "gl/upload.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "ink/trace_lines.h"
#include "lines/object_lines.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/placement.h"
#include "passes/read_maps.h"

namespace inkedge {
namespace {

void check(const Camera& camera) {
    const bool angleUsable = camera.orthographic() || (camera.viewAngle > 0.0 && camera.viewAngle < 180.0);
    const bool depthsUsable = camera.near < camera.far && (camera.orthographic() || camera.near > 0.0);
    const bool finite =
        std::isfinite(camera.near) && std::isfinite(camera.far) && std::isfinite(glm::determinant(camera.view));
    if (!angleUsable || !depthsUsable || !finite) {
        throw Error{
            Error::Kind::Usage,
            fmt::format("camera: expected a view angle over 0 and under 180 and 0 < near < far, all finite, found "
                        "{} and {}, {}",
                        camera.viewAngle, camera.near, camera.far)};
    }
}

// What one call draws.
struct View {
    gl::Gpu& gpu;
    const gl::UploadedScene& upload;
    const Scene& scene;
    const Camera& camera;
    const Settings& settings;
};

bool drawsClassic(const Settings& settings) { return settings.detector.detector == Detector::Classic; }

bool needsPlanes(const Settings& settings) {
    return !drawsClassic(settings) || wantsAny(settings, {Map::Types, Map::Ids});
}

bool needsSurface(const Settings& settings) {
    return drawsClassic(settings) ||
           wantsAny(settings, {Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges});
}

// What the triangles are drawn into.
struct Geometry {
    std::optional<PlaneBuffers> planes;
    std::optional<SurfaceBuffers> surface;
};

// In one pass where both are wanted, of one size and with lights that need one pass only.
Geometry drawGeometry(const View& view, gl::StageClock& clock) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const int samples = picture.supersampling;
    const bool planes = needsPlanes(settings);
    const bool surface = needsSurface(settings);
    Geometry geometry;
    if (planes && surface && samples == 1 && settings.detector.normalLights == NormalLights::Single) {
        PlanesAndSurface both =
            drawPlanesAndSurface(gpu, upload, scene, camera, settings.detector.lightSpace, picture.size);
        clock.finish("geometry");
        return {std::move(both.planes), std::move(both.surface)};
    }
    if (planes) {
        geometry.planes =
            drawPlanes(gpu, upload, scene, camera, {picture.size.width * samples, picture.size.height * samples});
        clock.finish("planes");
    }
    if (surface) {
        geometry.surface = drawSurface(gpu, upload, scene, camera, settings.detector, picture.size);
        clock.finish("surface");
    }
    return geometry;
}

// Depth and normal maps, their edges, and, for the classic detector, the picture.
void renderSurface(const View& view, const SurfaceBuffers& surface, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const bool keepMagnitudes = wantsAny(settings, {Map::DepthEdges, Map::NormalEdges});
    readSurface(gpu.api, surface, settings, maps);
    if (drawsClassic(settings) || keepMagnitudes) {
        const EdgeBuffers edges = detectEdges(gpu, surface.surface, camera, settings.detector,
                                              keepMagnitudes ? Magnitudes::Keep : Magnitudes::Drop);
        clock.finish("edges");
        if (drawsClassic(settings)) {
            maps.picture = composite(readMarks(gpu.api, edges), settings.picture);
            clock.finish("composite");
        }
        readEdges(gpu.api, edges, settings, maps);
    }
    clock.finish("read-back");
}

// Lines of the planes detector: their types, ids and, unless the classic detector draws it, the picture.
void renderPlanes(const View& view, const PlaneBuffers& buffers, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const double unit = unitLength(scene);

    LineBuffers lines;
    lines.marks = detectLines(gpu, buffers.planes, camera, unit, scene.creaseAngle());
    clock.finish("lines");
    lines.planes = gl::readFloats(gpu.api, buffers.planes, 4);
    lines.triangles = gl::readIntegers(gpu.api, buffers.triangles);
    clock.finish("read-back");
    TracedLines traced =
        traceLines(std::move(lines), scene, upload.firstTriangles(), camera, unit, drawnTypes(picture),
                   picture.supersampling, wants(settings, Map::Ids) ? TraceIds::Keep : TraceIds::Drop);
    clock.finish("trace");
    if (!drawsClassic(settings)) {
        if (wants(settings, Map::Edges)) maps.edges = mask(traced.types, picture.lines);
        maps.picture = paintStrokes(traced.strokes, picture);
        clock.finish("paint");
    }
    maps.ids = std::move(traced.ids);
    if (wants(settings, Map::Types)) maps.types = std::move(traced.types);
}

}  // namespace

struct Renderer::State {
    explicit State(const BackendSettings& wish) : context{gl::createContext(wish)} {
        const gl::Current current{*context};
        const gl::Api& api = context->api();
        GLint sides[3]{};
        api.GetIntegerv(GL_MAX_TEXTURE_SIZE, &sides[0]);
        GLint viewport[2]{};
        api.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
        maximumSize = std::min({sides[0], viewport[0], viewport[1]});
        gpu = std::make_unique<gl::Gpu>(api);
    }
    ~State() {
        const gl::Current current{*context};
        upload.reset();
        gpu.reset();
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void check(const PictureSettings& picture) const {
        const Size size = picture.size;
        if (picture.supersampling != 1 && picture.supersampling != 2 && picture.supersampling != 4) {
            throw Error{Error::Kind::Usage,
                        fmt::format("supersampling: expected 1, 2 or 4, found {}", picture.supersampling)};
        }
        const int most = maximumSize / picture.supersampling;
        if (size.width >= 1 && size.height >= 1 && size.width <= most && size.height <= most) return;
        throw Error{Error::Kind::Usage,
                    fmt::format("size: expected 1x1 to {0}x{0} pixels at supersampling {1}, found {2}x{3}", most,
                                picture.supersampling, size.width, size.height)};
    }

    const gl::UploadedScene& uploaded(const Scene& scene) {
        if (!upload || !upload->holds(scene)) {
            upload.reset();  // first: never two scenes in graphics memory
            upload = std::make_unique<gl::UploadedScene>(gpu->api, scene);
        }
        return *upload;
    }

    std::unique_ptr<gl::Context> context;
    int maximumSize = 0;
    std::unique_ptr<gl::Gpu> gpu;
    const lines::ObjectLines& prepared(const Scene& scene) {
        if (!objectLines || !objectLines->holds(scene)) {
            objectLines.reset();
            objectLines = std::make_unique<lines::ObjectLines>(scene);
        }
        return *objectLines;
    }

    std::unique_ptr<gl::UploadedScene> upload;
    std::unique_ptr<lines::ObjectLines> objectLines;
};

Renderer::Renderer(const BackendSettings& wish) : state_{std::make_unique<State>(wish)} {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

const BackendInfo& Renderer::backend() const noexcept { return state_->context->info(); }
int Renderer::maximumSize() const noexcept { return state_->maximumSize; }

Lines Renderer::lines(const Scene& scene, const Camera& camera, const Settings& settings) {
    check(camera);
    std::vector<StageTime> times;
    const auto begin = std::chrono::steady_clock::now();
    const lines::ObjectLines& prepared = state_->prepared(scene);
    times.push_back({"prepare lines", std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()});
    Lines found = prepared.find(camera, settings);
    found.backend = backend();
    found.times.insert(found.times.begin(), times.begin(), times.end());
    return found;
}

Maps Renderer::render(const Scene& scene, const Camera& camera, const Settings& settings) {
    state_->check(settings.picture);
    check(camera);
    const gl::Current current{*state_->context};
    Maps maps;
    maps.camera = camera;
    maps.backend = backend();
    gl::StageClock clock{state_->gpu->api, maps.times};
    if (settings.lines.from == LinesFrom::Object) {
        const Lines found = lines(scene, camera, settings);
        maps.times = found.times;
        maps.picture = paintStrokes(strokesOf(found, settings.picture, settings.lines), settings.picture);
        clock.finish("paint");
        return maps;
    }
    const View view{*state_->gpu, state_->uploaded(scene), scene, camera, settings};
    clock.finish("upload");
    const Geometry geometry = drawGeometry(view, clock);
    if (geometry.planes) renderPlanes(view, *geometry.planes, clock, maps);
    if (geometry.surface) renderSurface(view, *geometry.surface, clock, maps);
    state_->gpu->textures.trim();
    return maps;
}

}  // namespace inkedge

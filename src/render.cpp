#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <inkedge/renderer.h>

#include "gl/context.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/stage_clock.h"
#include "gl/upload.h"
#include "ink/paint_strokes.h"
#include "ink/trace_lines.h"
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

// Depth and normal maps, their edges, and, for the classic detector, the picture.
void renderSurface(const View& view, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const bool classic = settings.detector.detector == Detector::Classic;
    const bool keepMagnitudes = wantsAny(settings, {Map::DepthEdges, Map::NormalEdges});

    const SurfaceBuffers surface = drawSurface(gpu, upload, scene, camera, settings.detector, settings.picture.size);
    clock.finish("surface");
    readSurface(gpu.api, surface, settings, maps);
    if (classic || keepMagnitudes) {
        const EdgeBuffers edges = detectEdges(gpu, surface.surface, camera, settings.detector,
                                              keepMagnitudes ? Magnitudes::Keep : Magnitudes::Drop);
        clock.finish("edges");
        if (classic) {
            const gl::Texture picture = composite(gpu, edges.marks, settings.picture);
            clock.finish("composite");
            maps.picture = readPicture(gpu.api, picture, settings.picture);
        }
        readEdges(gpu.api, edges, settings, maps);
    }
    clock.finish("read-back");
}

// Lines of the planes detector: their types, ids and, unless the classic detector draws it, the picture.
void renderPlanes(const View& view, gl::StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const bool classic = settings.detector.detector == Detector::Classic;
    const int samples = picture.supersampling;
    const double unit = unitLength(scene);

    const PlaneBuffers buffers =
        drawPlanes(gpu, upload, scene, camera, {picture.size.width * samples, picture.size.height * samples});
    clock.finish("planes");
    LineBuffers lines;
    lines.marks = detectLines(gpu, buffers.planes, camera, unit, scene.creaseAngle());
    clock.finish("lines");
    lines.planes = gl::readFloats(gpu.api, buffers.planes, 4);
    lines.triangles = gl::readIntegers(gpu.api, buffers.triangles);
    clock.finish("read-back");
    TracedLines traced = traceLines(std::move(lines), scene, upload.firstTriangles(), camera, unit, drawnTypes(picture),
                                    samples, wants(settings, Map::Ids) ? TraceIds::Keep : TraceIds::Drop);
    clock.finish("trace");
    if (!classic) {
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
    std::unique_ptr<gl::UploadedScene> upload;
};

Renderer::Renderer(const BackendSettings& wish) : state_{std::make_unique<State>(wish)} {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

const BackendInfo& Renderer::backend() const noexcept { return state_->context->info(); }
int Renderer::maximumSize() const noexcept { return state_->maximumSize; }

Maps Renderer::render(const Scene& scene, const Camera& camera, const Settings& settings) {
    state_->check(settings.picture);
    check(camera);
    const gl::Current current{*state_->context};
    Maps maps;
    maps.camera = camera;
    maps.backend = backend();
    gl::StageClock clock{state_->gpu->api, maps.times};
    const View view{*state_->gpu, state_->uploaded(scene), scene, camera, settings};
    clock.finish("upload");
    if (settings.detector.detector == Detector::Planes) {
        renderPlanes(view, clock, maps);
        if (wantsAny(settings, {Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges})) {
            renderSurface(view, clock, maps);
        }
    } else {
        renderSurface(view, clock, maps);
        if (wantsAny(settings, {Map::Types, Map::Ids})) renderPlanes(view, clock, maps);
    }
    state_->gpu->textures.trim();
    return maps;
}

}  // namespace inkedge

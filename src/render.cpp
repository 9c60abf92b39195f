#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <inkedge/renderer.h>

#include "gl/context.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/upload.h"
#include "ink/paint_strokes.h"
#include "ink/trace_lines.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/placement.h"

namespace inkedge {
namespace {

bool wants(const Settings& settings, Map map) { return std::ranges::find(settings.maps, map) != settings.maps.end(); }

bool wantsAny(const Settings& settings, std::initializer_list<Map> maps) {
    return std::ranges::any_of(maps, [&](Map map) { return wants(settings, map); });
}

// Times stages, and stops at the first that left a GL error.
class StageClock {
public:
    StageClock(const gl::Api& api, std::vector<StageTime>& times) : api_{api}, times_{times} {}

    void finish(const char* stage) {
        api_.Finish();
        if (const GLenum error = api_.GetError(); error != GL_NO_ERROR) {
            throw Error{Error::Kind::Runtime,
                        error == GL_OUT_OF_MEMORY
                            ? fmt::format("{}: expected enough graphics memory, found too little; ask for a smaller --size",
                                          stage)
                            : fmt::format("{}: expected no OpenGL error, found {:#x}", stage, error)};
        }
        const auto now = std::chrono::steady_clock::now();
        times_.push_back({stage, std::chrono::duration<double, std::milli>(now - begin_).count()});
        begin_ = now;
    }

private:
    const gl::Api& api_;
    std::vector<StageTime>& times_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void readSurface(const gl::Api& api, const SurfaceBuffers& buffers, const Settings& settings, Maps& maps) {
    if (wants(settings, Map::Depth)) {
        maps.windowDepth = gl::readDepth(api, buffers.depth);
        for (float& z : maps.windowDepth.pixels) z = 1.0F - z;
    }
    if (!wantsAny(settings, {Map::Depth, Map::Normal})) return;
    const Image<float> surface = gl::readFloats(api, buffers.surface, 4);
    const std::size_t count = surface.pixels.size() / 4;
    if (wants(settings, Map::Depth)) {
        maps.depth = Image<float>{surface.size, 1};
        for (std::size_t i = 0; i < count; ++i) maps.depth.pixels[i] = surface.pixels[4 * i + 3];
    }
    if (wants(settings, Map::Normal)) {
        maps.normal = Image<float>{surface.size, 3};
        for (std::size_t i = 0; i < count; ++i) {
            std::copy_n(surface.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                        maps.normal.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
    }
}

Image<std::uint8_t> mask(const Image<std::uint8_t>& marks, unsigned bits) {
    Image<std::uint8_t> edges{marks.size, 1};
    std::ranges::transform(marks.pixels, edges.pixels.begin(),
                           [&](std::uint8_t m) { return static_cast<std::uint8_t>((m & bits) != 0 ? 255 : 0); });
    return edges;
}

void readEdges(const gl::Api& api, const EdgeBuffers& buffers, const Settings& settings, Maps& maps) {
    const bool depth = wants(settings, Map::DepthEdges);
    const bool normal = wants(settings, Map::NormalEdges);
    const bool both = wants(settings, Map::Edges) && settings.detector.detector == Detector::Classic;
    if (!depth && !normal && !both) return;
    const Image<std::uint8_t> marks = gl::readBytes(api, buffers.marks, 1);
    if (depth) maps.depthEdges = mask(marks, EdgeBuffers::depthEdge);
    if (normal) maps.normalEdges = mask(marks, EdgeBuffers::normalEdge);
    if (both) maps.edges = mask(marks, EdgeBuffers::depthEdge | EdgeBuffers::normalEdge);
    if (!buffers.magnitudes) return;
    const Image<float> magnitudes = gl::readFloats(api, *buffers.magnitudes, 2);
    if (depth) maps.depthMagnitude = Image<float>{marks.size, 1};
    if (normal) maps.normalMagnitude = Image<float>{marks.size, 1};
    for (std::size_t i = 0; i < marks.pixels.size(); ++i) {
        if (depth) maps.depthMagnitude.pixels[i] = magnitudes.pixels[2 * i];
        if (normal) maps.normalMagnitude.pixels[i] = magnitudes.pixels[2 * i + 1];
    }
}

// A pixel's types are those of all its samples.
Image<std::uint8_t> typesOfPixels(const Image<std::uint8_t>& samples, int samplesPerPixel) {
    if (samplesPerPixel == 1) return samples;
    Image<std::uint8_t> types{{samples.size.width / samplesPerPixel, samples.size.height / samplesPerPixel}, 1};
    for (int y = 0; y < samples.size.height; ++y) {
        for (int x = 0; x < samples.size.width; ++x) types.at(x / samplesPerPixel, y / samplesPerPixel) |= samples.at(x, y);
    }
    return types;
}

// A pixel's ids are those of its first sample on a line, or of its middle one.
Image<std::uint32_t> idsOfPixels(const TracedLines& traced, int samplesPerPixel) {
    if (samplesPerPixel == 1) return traced.ids;
    const Size size{traced.ids.size.width / samplesPerPixel, traced.ids.size.height / samplesPerPixel};
    Image<std::uint32_t> ids{size, traced.ids.channels};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            int fromX = x * samplesPerPixel + samplesPerPixel / 2;
            int fromY = y * samplesPerPixel + samplesPerPixel / 2;
            for (int i = samplesPerPixel * samplesPerPixel - 1; i >= 0; --i) {
                const int sampleX = x * samplesPerPixel + i % samplesPerPixel;
                const int sampleY = y * samplesPerPixel + i / samplesPerPixel;
                if (traced.types.at(sampleX, sampleY) == 0) continue;
                fromX = sampleX;
                fromY = sampleY;
            }
            std::copy_n(&traced.ids.at(fromX, fromY), ids.channels, &ids.at(x, y));
        }
    }
    return ids;
}

Image<std::uint8_t> readPicture(const gl::Api& api, const gl::Texture& picture, const PictureSettings& settings) {
    const int channels = picture.format() == GL_R8 ? 1 : settings.background ? 3 : 4;
    return gl::readBytes(api, picture, channels);
}

void check(const Camera& camera) {
    const bool angleUsable = camera.orthographic() || (camera.viewAngle > 0.0 && camera.viewAngle < 180.0);
    const bool depthsUsable = camera.near < camera.far && (camera.orthographic() || camera.near > 0.0);
    const bool finite = std::isfinite(camera.near) && std::isfinite(camera.far) &&
                        std::isfinite(glm::determinant(camera.view));
    if (!angleUsable || !depthsUsable || !finite) {
        throw Error{Error::Kind::Usage,
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
void renderSurface(const View& view, StageClock& clock, Maps& maps) {
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
void renderPlanes(const View& view, StageClock& clock, Maps& maps) {
    const auto& [gpu, upload, scene, camera, settings] = view;
    const PictureSettings& picture = settings.picture;
    const bool classic = settings.detector.detector == Detector::Classic;
    const int samples = picture.supersampling;
    const double unit = unitLength(scene);

    const PlaneBuffers buffers =
        drawPlanes(gpu, upload, scene, camera, {picture.size.width * samples, picture.size.height * samples});
    clock.finish("planes");
    LineBuffers lines;
    lines.marks = detectLines(gpu, buffers.planes, camera, unit, settings.load.creaseAngle);
    clock.finish("lines");
    lines.planes = gl::readFloats(gpu.api, buffers.planes, 4);
    lines.triangles = gl::readIntegers(gpu.api, buffers.triangles);
    clock.finish("read-back");
    const TracedLines traced =
        traceLines(lines, scene, upload.firstTriangles(), camera, unit, picture.lines, samples,
                   wants(settings, Map::Ids) ? TraceIds::Keep : TraceIds::Drop);
    clock.finish("trace");
    if (wants(settings, Map::Types)) maps.types = typesOfPixels(traced.types, samples);
    if (wants(settings, Map::Ids)) maps.ids = idsOfPixels(traced, samples);
    if (!classic) {
        if (wants(settings, Map::Edges)) maps.edges = mask(typesOfPixels(traced.types, samples), picture.lines);
        maps.picture = paintStrokes(traced.strokes, picture);
        clock.finish("paint");
    }
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
    StageClock clock{state_->gpu->api, maps.times};
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

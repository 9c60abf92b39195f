#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <inkedge/camera.h>
#include <inkedge/settings.h>

#include "gl/context.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/upload.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "meshes.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/frame.h"
#include "passes/read_maps.h"
#include "trace/trace_lines.h"

namespace inkedge::benchmarks {

using namespace ink;
using namespace passes;
using namespace raster;
using namespace trace;

inline constexpr Size sizes[]{{1024, 1024}, {1920, 1080}, {3840, 2160}};
inline constexpr std::uint64_t triangleCounts[]{10'000, 100'000, 1'000'000};
inline constexpr std::uint64_t usualTriangles = 100'000;  // where only the size varies

struct Model {
    Shape shape;
    std::uint64_t triangles;
    friend auto operator<=>(const Model&, const Model&) = default;
};
inline constexpr Model usualModel{Shape::Cad, usualTriangles};

inline std::string nameOf(Model model) { return fmt::format("{}/{}", nameOf(model.shape), model.triangles); }
inline std::string nameOf(Size size) { return fmt::format("{}x{}", size.width, size.height); }
inline std::int64_t pixelsOf(Size size) { return std::int64_t{size.width} * size.height; }

// The value of a key, made when it is first asked for.
template <class Key, class Value, class Make>
inline const Value& made(std::map<Key, std::unique_ptr<Value>>& all, const Key& key, Make make) {
    std::unique_ptr<Value>& value = all[key];
    if (!value) value = std::make_unique<Value>(make());
    return *value;
}

// A folder of our own, gone with its owner.
class TemporaryFolder {
public:
    TemporaryFolder()
        : path_{std::filesystem::temp_directory_path() /
                fmt::format("inkedge-benchmark-{:x}", std::random_device{}())} {
        std::filesystem::create_directory(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
};

// What a view of the usual model leaves from stage to stage.
struct Buffers {
    PlaneBuffers planes;
    SurfaceBuffers surface;
    EdgeMarks edges;
    LineBuffers lines;
    TracedLines traced;
    Image<std::uint8_t> picture;
};

// Everything that the benchmarks draw with and draw; made when first asked for.
class Equipment {
public:
    Equipment() : context_{gl::createContext({})}, current_{*context_}, gpu_{context_->api()} {}

    [[nodiscard]] gl::Gpu& gpu() noexcept { return gpu_; }
    [[nodiscard]] const gl::Api& api() const noexcept { return gpu_.api; }
    [[nodiscard]] const BackendInfo& backend() const noexcept { return context_->info(); }

    const Mesh& mesh(Model model) {
        return made(meshes_, model, [&] { return makeMesh(model.shape, model.triangles); });
    }
    const std::filesystem::path& file(Model model) {
        return made(files_, model, [&] {
            const auto path = folder_.path() / fmt::format("{}-{}.glb", nameOf(model.shape), model.triangles);
            writeGlb(mesh(model), path);
            return path;
        });
    }
    const Scene& scene(Model model) {
        return made(scenes_, model, [&] { return Scene{sceneData(model)}; });
    }
    Scene::Data sceneData(Model model) {
        Scene::Data data;
        data.meshes = {mesh(model)};
        data.instances = {Instance{}};
        return data;
    }
    const gl::UploadedScene& upload(Model model) {
        return made(uploads_, model, [&] { return gl::UploadedScene{api(), scene(model)}; });
    }
    const Buffers& buffers(Size size) {
        return made(buffers_, nameOf(size), [&] { return draw(size); });
    }

    const Camera& camera(Model model, Size size) {
        return made(cameras_, nameOf(model) + nameOf(size), [&] { return frameCamera(scene(model), {}, size); });
    }
    Frame frame(Model model, Size size) {
        return frameOf(gpu_, upload(model), scene(model), camera(model, size), size);
    }

    // The OpenCV yardstick's width: --line-width 2.
    static PictureSettings pictureSettings(Size size) {
        PictureSettings picture;
        picture.size = size;
        picture.lineWidth = {2.0, false};
        return picture;
    }

    TracedLines trace(LineBuffers lines, Size size) {
        const Frame shown = frame(usualModel, size);
        const ScreenTriangles triangles{shown.scene, shown.upload.firstTriangles(), shown.camera, size};
        return traceLines(std::move(lines), shown.scene, triangles, {}, shown.camera, shown.unit,
                          drawnTypes(pictureSettings(size)), 1, TraceIds::Drop);
    }

    Image<std::uint8_t> findLines(const PlaneBuffers& planes, Size size) {
        return detectLines(frame(usualModel, size), planes.planes, scene(usualModel).creaseAngle());
    }

private:
    Buffers draw(Size size) {
        const Frame shown = frame(usualModel, size);
        PlaneBuffers planes = drawPlanes(shown);
        SurfaceBuffers surface = drawSurface(shown, {});
        EdgeMarks edges = readMarks(api(), detectEdges(gpu_, surface.surface, shown.camera, {}, Magnitudes::Drop));
        LineBuffers lines;
        lines.tile = size;
        lines.marks = findLines(planes, size);
        const std::vector<Rectangle> regions = regionsAround(lines.marks);
        lines.planes = gl::readFloats(api(), planes.planes, 4, regions);
        lines.triangles = gl::readIntegers(api(), planes.triangles, regions);
        TracedLines traced = trace(lines, size);
        Image<std::uint8_t> picture = paintStrokes(strokesOf(traced.pieces), pictureSettings(size));
        return {std::move(planes), std::move(surface), std::move(edges),
                std::move(lines),  std::move(traced),  std::move(picture)};
    }

    std::unique_ptr<gl::Context> context_;
    gl::Current current_;
    gl::Gpu gpu_;
    TemporaryFolder folder_;
    std::map<Model, std::unique_ptr<Mesh>> meshes_;
    std::map<Model, std::unique_ptr<std::filesystem::path>> files_;
    std::map<Model, std::unique_ptr<Scene>> scenes_;
    std::map<Model, std::unique_ptr<gl::UploadedScene>> uploads_;
    std::map<std::string, std::unique_ptr<Camera>> cameras_;
    std::map<std::string, std::unique_ptr<Buffers>> buffers_;
};

// Runs work until its time is known. What it needs must be there before.
template <class Work>
void repeat(benchmark::State& state, Work work) {
    work();  // the first time compiles programs and allocates textures
    for (auto _ : state) work();
}

inline benchmark::internal::Benchmark* add(const std::string& name, std::function<void(benchmark::State&)> run) {
    return benchmark::RegisterBenchmark(name.c_str(), std::move(run))
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

}  // namespace inkedge::benchmarks

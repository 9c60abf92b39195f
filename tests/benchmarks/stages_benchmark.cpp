// Times every stage of a render by itself, and yardsticks for them. tools/bench runs it and says what the figures mean.
//   stages_benchmark [--benchmark_filter=REGEX ...]
// Names are STAGE/SIZE, STAGE/SHAPE/TRIANGLES or STAGE/SHAPE/TRIANGLES/SIZE. Every stage is waited for before its time
// is taken; cpu_time is that of all threads. Those in device/ are timed by the graphics processor's own clock.
#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <inkedge/load_scene.h>
#include <inkedge/renderer.h>
#include <inkedge/write.h>

#include "equipment.h"
#include "gl/context.h"
#include "gl/draw.h"
#include "gl/gpu.h"
#include "gl/read_back.h"
#include "gl/upload.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "meshes.h"
#include "passes/composite.h"
#include "passes/detect_edges.h"
#include "passes/detect_lines.h"
#include "passes/draw_function.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/frame.h"
#include "passes/function_edges.h"
#include "passes/read_maps.h"
#ifdef INKEDGE_OPENCV
#include "opencv_edges.h"
#endif

namespace inkedge::benchmarks {
namespace {

void addMemcpy(const std::string& name, std::function<std::size_t()> bytesOf) {
    add("memcpy/" + name, [bytesOf](benchmark::State& state) {
        const std::size_t bytes = bytesOf();
        const std::vector<char> from(bytes, 'x');
        std::vector<char> to(bytes, 'y');
        repeat(state, [&] {
            std::memcpy(to.data(), from.data(), bytes);
            benchmark::ClobberMemory();
        });
        state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
    });
}

void addContext() {
    add("context", [](benchmark::State& state) {
        repeat(state, [] { benchmark::DoNotOptimize(gl::createContext({})->info().software); });
    });
}

void addModel(Equipment& equipment, Model model) {
    const auto countTriangles = [&equipment, model](benchmark::State& state) {
        state.counters["triangles"] = static_cast<double>(equipment.mesh(model).indices.size()) / 3.0;
    };
    add("load/" + nameOf(model), [&equipment, model, countTriangles](benchmark::State& state) {
        const auto& file = equipment.file(model);
        repeat(state, [&] { benchmark::DoNotOptimize(loadScene(file).triangleCount()); });
        countTriangles(state);
    });
    add("prepare/" + nameOf(model), [&equipment, model, countTriangles](benchmark::State& state) {
        for (auto _ : state) {
            state.PauseTiming();
            Scene::Data data = equipment.sceneData(model);
            state.ResumeTiming();
            benchmark::DoNotOptimize(Scene{std::move(data)}.triangleCount());
        }
        countTriangles(state);
    });
    add("upload/" + nameOf(model), [&equipment, model, countTriangles](benchmark::State& state) {
        const Scene& scene = equipment.scene(model);
        repeat(state, [&] {
            const gl::UploadedScene upload{equipment.api(), scene};
            equipment.api().Finish();
        });
        countTriangles(state);
    });
    addMemcpy("mesh/" + nameOf(model), [&equipment, model] {
        const Mesh& mesh = equipment.mesh(model);
        return (mesh.positions.size() + mesh.normals.size()) * sizeof(glm::vec3) +
               mesh.indices.size() * sizeof(std::uint32_t);
    });
}

void addGeometry(Equipment& equipment, Model model, Size size) {
    const std::string suffix = nameOf(model) + "/" + nameOf(size);
    add("planes/" + suffix, [&equipment, model, size](benchmark::State& state) {
        const Frame frame = equipment.frame(model, size);
        repeat(state, [&] {
            const PlaneBuffers planes = drawPlanes(frame);
            equipment.api().Finish();
        });
    });
    add("surface/" + suffix, [&equipment, model, size](benchmark::State& state) {
        const Frame frame = equipment.frame(model, size);
        repeat(state, [&] {
            const SurfaceBuffers surface = drawSurface(frame, {});
            equipment.api().Finish();
        });
    });
}

DetectorSettings classicSettings(Kernel kernel) {
    DetectorSettings settings;
    settings.detector = Detector::Classic;
    settings.kernel = kernel;
    return settings;
}

#ifdef INKEDGE_OPENCV
// What detectEdges() finds, as one byte a pixel.
Image<std::uint8_t> edgeMarks(Equipment& equipment, Kernel kernel, Size size) {
    Maps maps;
    readEdges(equipment.api(),
              detectEdges(equipment.gpu(), equipment.buffers(size).surface.surface, equipment.camera(usualModel, size),
                          classicSettings(kernel), Magnitudes::Drop),
              {.depth = true, .normal = true}, maps);
    Image<std::uint8_t> marks{size, 1};
    for (std::size_t i = 0; i < marks.pixels().size(); ++i) {
        marks.mutablePixels()[i] =
            static_cast<std::uint8_t>((maps.depthEdges.pixels()[i] != 0 ? EdgeMarks::depthEdge : 0) |
                                      (maps.normalEdges.mutablePixels()[i] != 0 ? EdgeMarks::normalEdge : 0));
    }
    return marks;
}
#endif

void addClassic(Equipment& equipment, Kernel kernel, const std::string& kernelName, Size size) {
    add("edges-" + kernelName + "/" + nameOf(size), [&equipment, kernel, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        const Camera camera = equipment.camera(usualModel, size);
        repeat(state, [&] {
            const EdgeBuffers edges = detectEdges(equipment.gpu(), buffers.surface.surface, camera,
                                                  classicSettings(kernel), Magnitudes::Drop);
            equipment.api().Finish();
        });
    });
#ifdef INKEDGE_OPENCV
    add("opencv-" + kernelName + "/" + nameOf(size), [&equipment, kernel, size](benchmark::State& state) {
        Image<float> surface = gl::readFloats(equipment.api(), equipment.buffers(size).surface.surface, 4);
        const Camera camera = equipment.camera(usualModel, size);
        for (std::size_t i = 3; i < surface.pixels().size(); i += 4) {
            const double depth =
                (static_cast<double>(surface.mutablePixels()[i]) - camera.near) / (camera.far - camera.near);
            surface.mutablePixels()[i] = static_cast<float>(depth);
        }
        OpenCvEdges edges{surface, kernel, thresholds(classicSettings(kernel))};
        const std::uint8_t* found = nullptr;
        repeat(state, [&] { found = edges.detect(); });
        const Image<std::uint8_t> expected = edgeMarks(equipment, kernel, size);
        state.counters["edge_pixels"] = static_cast<double>(std::count_if(
            expected.pixels().begin(), expected.pixels().end(), [](std::uint8_t mark) { return mark != 0; }));
        state.counters["differing_pixels"] =
            std::inner_product(expected.pixels().begin(), expected.pixels().end(), found, 0.0, std::plus<>{},
                               [](std::uint8_t a, std::uint8_t b) { return a == b ? 0.0 : 1.0; });
    });
#endif
}

// The program's own work without read-back. Draws to two targets in turn: drivers that draw tile by tile leave out what
// the next run covers.
class LinesPass {
public:
    LinesPass(Equipment& equipment, Size size)
        : gpu_{equipment.gpu()},
          planes_{equipment.buffers(size).planes.planes},
          blocks_{acquireBlocks(size), acquireBlocks(size)},
          targets_{gl::Framebuffer{gpu_.api, {&blocks_[0]}}, gl::Framebuffer{gpu_.api, {&blocks_[1]}}} {
        // Sets the program's uniforms.
        benchmark::DoNotOptimize(equipment.findLines(equipment.buffers(size).planes, size).pixels().data());
    }
    void run() {
        turn_ = 1 - turn_;
        gl::drawFullscreen(gpu_, gl::Program::DetectLines, targets_[turn_], {&planes_});
    }

private:
    [[nodiscard]] gl::Texture acquireBlocks(Size size) const {
        return gpu_.textures.acquire({(size.width + 3) / 4, (size.height + 3) / 4}, GL_RGBA32UI);
    }

    gl::Gpu& gpu_;
    const gl::Texture& planes_;
    gl::Texture blocks_[2];
    gl::Framebuffer targets_[2];
    std::size_t turn_ = 0;
};

void addPlanesDetector(Equipment& equipment, Size size) {
    add("lines/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        repeat(state, [&] { benchmark::DoNotOptimize(equipment.findLines(buffers.planes, size).pixels().data()); });
    });
    add("lines-pass/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        LinesPass pass{equipment, size};
        repeat(state, [&] {
            pass.run();
            equipment.api().Finish();
        });
    });
    add("trace/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        for (auto _ : state) {
            state.PauseTiming();
            LineBuffers lines = buffers.lines;
            state.ResumeTiming();
            benchmark::DoNotOptimize(equipment.trace(std::move(lines), size).pieces.data());
        }
        state.counters["strokes"] = static_cast<double>(buffers.traced.pieces.size());
    });
    add("paint/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        const PictureSettings picture = Equipment::pictureSettings(size);
        repeat(state, [&] {
            benchmark::DoNotOptimize(paintStrokes(strokesOf(buffers.traced.pieces), picture).pixels().data());
        });
    });
}

// Of a function without a value on the background, and of one whose differences are wrapped.
void addFunctions(Equipment& equipment, Size size) {
    for (const auto& [text, name] : {std::pair{"height", "sobel"}, std::pair{"height:kernel=farid", "farid"},
                                     std::pair{"uv", "wrapped-sobel"}, std::pair{"uv:kernel=farid", "wrapped-farid"}}) {
        const FunctionSettings function = surfaceFunction(text);
        const auto draw = [&equipment, size] {
            gl::FunctionInputs inputs{equipment.api()};
            return drawFunction(equipment.frame(usualModel, size), inputs, surfaceFunction("height"));
        };
        if (name == std::string_view{"sobel"}) {
            add("function/" + nameOf(size), [&equipment, draw](benchmark::State& state) {
                repeat(state, [&] {
                    const gl::Texture values = draw();
                    equipment.api().Finish();
                });
            });
        }
        add(fmt::format("function-{}/{}", name, nameOf(size)), [&equipment, draw, function](benchmark::State& state) {
            const gl::Texture values = draw();
            repeat(state, [&] {
                const gl::Texture marks = detectFunction(equipment.gpu(), values, function);
                equipment.api().Finish();
            });
        });
    }
}

void addOutput(Equipment& equipment, Size size) {
    add("composite/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        const PictureSettings picture = Equipment::pictureSettings(size);
        repeat(state, [&] { benchmark::DoNotOptimize(composite(buffers.edges, picture).pixels().data()); });
    });
    add("read-back/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const PlaneBuffers& planes = equipment.buffers(size).planes;
        const Image<std::uint8_t>& marks = equipment.buffers(size).lines.marks;
        repeat(state, [&] {
            const std::vector<Rectangle> regions = regionsAround(marks);
            benchmark::DoNotOptimize(gl::readFloats(equipment.api(), planes.planes, 4, regions).values.get());
            benchmark::DoNotOptimize(gl::readIntegers(equipment.api(), planes.triangles, regions).values.get());
        });
    });
    add("encode/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Buffers& buffers = equipment.buffers(size);
        std::size_t bytes = 0;
        repeat(state, [&] { bytes = encodePng(buffers.picture).size(); });
        state.counters["bytes"] = static_cast<double>(bytes);
    });
    const auto pixels = static_cast<std::size_t>(pixelsOf(size));
    addMemcpy("surface/" + nameOf(size), [pixels] { return pixels * 16; });
    addMemcpy("planes-triangles/" + nameOf(size), [pixels] { return pixels * 20; });
    addMemcpy("picture/" + nameOf(size), [pixels] { return pixels; });
}

// A view of a turntable in a renderer that is warm, to the bytes of its PNG.
void addView(Equipment& equipment, Model model, Size size) {
    add("view/" + nameOf(model) + "/" + nameOf(size), [&equipment, model, size](benchmark::State& state) {
        const Scene& scene = equipment.scene(model);
        Renderer renderer;
        Settings settings;
        settings.picture.size = size;
        double azimuth = 0.0;
        repeat(state, [&] {
            settings.camera.azimuthAngle = azimuth;
            settings.camera.elevationAngle = 20.0;
            azimuth += 7.0;
            const Maps maps = renderer.render(scene, frameCamera(scene, settings.camera, size), settings);
            benchmark::DoNotOptimize(encodePng(maps.picture).data());
        });
    });
}

// Times work with the graphics processor's clock: several runs at once, so that it never waits for the next command.
class DeviceClock {
public:
    explicit DeviceClock(const gl::Api& api) : api_{api} { api_.CreateQueries(GL_TIME_ELAPSED, 1, &query_); }
    ~DeviceClock() { api_.DeleteQueries(1, &query_); }
    DeviceClock(const DeviceClock&) = delete;
    DeviceClock& operator=(const DeviceClock&) = delete;

    template <class Work>
    void time(benchmark::State& state, std::int64_t bytes, Work work) {
        constexpr int runs = 10;
        work();
        api_.Finish();
        for (auto _ : state) {
            api_.BeginQuery(GL_TIME_ELAPSED, query_);
            for (int i = 0; i < runs; ++i) work();
            api_.EndQuery(GL_TIME_ELAPSED);
            GLuint64 nanoseconds = 0;
            api_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
            state.SetIterationTime(static_cast<double>(nanoseconds) * 1e-9 / runs);
        }
        state.SetBytesProcessed(state.iterations() * bytes);
    }

private:
    const gl::Api& api_;
    GLuint query_ = 0;
};

void addDevice(Equipment& equipment, Size size) {
    const auto addTimed = [](const std::string& name, std::function<void(benchmark::State&)> run) {
        benchmark::RegisterBenchmark(("device/" + name).c_str(), std::move(run))
            ->Unit(benchmark::kMillisecond)
            ->Iterations(10)  // drivers whose clock stands still would never be done
            ->UseManualTime();
    };
    const std::int64_t edgeBytes = pixelsOf(size) * 16 + pixelsOf(size) / 4;  // read; written, two bits a pixel
    const std::int64_t lineBytes = pixelsOf(size) * 17;
    for (const auto& [kernel, name] : {std::pair{Kernel::Sobel, "sobel"}, std::pair{Kernel::Farid, "farid"}}) {
        addTimed(fmt::format("edges-{}/{}", name, nameOf(size)),
                 [&equipment, kernel = kernel, size, edgeBytes](benchmark::State& state) {
                     const Buffers& buffers = equipment.buffers(size);
                     const Camera camera = equipment.camera(usualModel, size);
                     DeviceClock{equipment.api()}.time(state, edgeBytes, [&] {
                         const EdgeBuffers edges = detectEdges(equipment.gpu(), buffers.surface.surface, camera,
                                                               classicSettings(kernel), Magnitudes::Drop);
                     });
                 });
    }
    addTimed("lines-pass/" + nameOf(size), [&equipment, size, lineBytes](benchmark::State& state) {
        LinesPass pass{equipment, size};
        DeviceClock{equipment.api()}.time(state, lineBytes, [&] { pass.run(); });
    });
    addTimed("planes/" + nameOf(usualModel) + "/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const Frame frame = equipment.frame(usualModel, size);
        DeviceClock{equipment.api()}.time(state, 0, [&] { const PlaneBuffers planes = drawPlanes(frame); });
    });
    // Texture to texture: what the edge passes' bandwidth is a share of. Each byte is read and written.
    addTimed("copy/" + nameOf(size), [&equipment, size](benchmark::State& state) {
        const gl::Texture& from = equipment.buffers(size).surface.surface;
        const gl::Texture to = equipment.gpu().textures.acquire(size, GL_RGBA32F);
        DeviceClock{equipment.api()}.time(state, pixelsOf(size) * 32, [&] {
            equipment.api().CopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                                             size.width, size.height, 1);
        });
    });
}

void addAll(Equipment& equipment) {
    addContext();
    for (const std::uint64_t triangles : triangleCounts) {
        for (const Shape shape : {Shape::Cad, Shape::Smooth}) addModel(equipment, {shape, triangles});
        for (const Size size : sizes) addGeometry(equipment, {Shape::Cad, triangles}, size);
        addView(equipment, {Shape::Cad, triangles}, {1024, 1024});
    }
    addGeometry(equipment, {Shape::Smooth, usualTriangles}, {1920, 1080});
    for (const Size size : sizes) {
        addPlanesDetector(equipment, size);
        addClassic(equipment, Kernel::Sobel, "sobel", size);
        addClassic(equipment, Kernel::Farid, "farid", size);
        addFunctions(equipment, size);
        addOutput(equipment, size);
    }
    addDevice(equipment, {3840, 2160});
    addDevice(equipment, {7680, 4320});
}

void describe(const Equipment& equipment) {
    const BackendInfo& backend = equipment.backend();
    const auto text = [&](GLenum name) {
        return std::string{reinterpret_cast<const char*>(equipment.api().GetString(name))};
    };
    benchmark::AddCustomContext("backend", fmt::format("{} ({})", backend.backend, backend.platform));
    benchmark::AddCustomContext("vendor", text(GL_VENDOR));
    benchmark::AddCustomContext("renderer", text(GL_RENDERER));
    benchmark::AddCustomContext("version", text(GL_VERSION));
    benchmark::AddCustomContext("software", backend.software ? "yes" : "no");
#ifdef INKEDGE_OPENCV
    benchmark::AddCustomContext("opencv", "yes");
#else
    benchmark::AddCustomContext("opencv", "no");
#endif
}

}  // namespace
}  // namespace inkedge::benchmarks

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    try {
        inkedge::benchmarks::Equipment equipment;
        inkedge::benchmarks::describe(equipment);
        inkedge::benchmarks::addAll(equipment);
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    } catch (const std::exception& error) {
        fmt::print(stderr, "stages_benchmark: error: {}\n", error.what());
        return 1;
    }
}

// Times what lines of object space take: their preparation, the finders of contour edges, and whole views by stages.
//   lines_benchmark [--benchmark_filter=REGEX ...]
// Names are STAGE/SHAPE/TRIANGLES; finders' end in every, random or gauss. Views are those of a turntable, 3 degrees
// apart. cpu_time is that of all threads. Needs no OpenGL.
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/camera.h>
#include <inkedge/lines.h>

#include "lines/find/contour_finders.h"
#include "lines/find/mesh_edges.h"
#include "lines/object_lines.h"
#include "lines/see/ray_caster.h"
#include "mesh/topology.h"
#include "meshes.h"
#include "scene/prepared.h"

namespace inkedge::benchmarks {
namespace {

using namespace lines;

constexpr std::uint64_t finderCounts[]{66'667, 666'667, 2'000'000};  // triangles: 100,000, 1 and 3 million edges
constexpr std::uint64_t viewCounts[]{100'000, 1'000'000};
constexpr Shape shapes[]{Shape::Cad, Shape::Smooth};
constexpr double step = 3.0;  // degrees per view
constexpr Size size{1024, 1024};

struct Model {
    Shape shape;
    std::uint64_t triangles;
    friend auto operator<=>(const Model&, const Model&) = default;
};

std::string nameOf(Model model) { return fmt::format("{}/{}", nameOf(model.shape), model.triangles); }

struct Prepared {
    explicit Prepared(Model model) : scene{dataOf(model)} {}

    static Scene::Data dataOf(Model model) {
        Scene::Data data;
        data.meshes = {makeMesh(model.shape, model.triangles)};
        data.instances = {Instance{}};
        return data;
    }

    Scene scene;
    MeshEdges edges = findEdges(scene.meshes()[0], scene::topologyOf(scene, 0), scene.creaseAngle());
};

// One model at a time: the largest take hundreds of megabytes.
const Prepared& prepared(Model model) {
    static std::optional<std::pair<Model, std::unique_ptr<Prepared>>> kept;
    if (!kept || kept->first != model) {
        kept.reset();
        kept.emplace(model, std::make_unique<Prepared>(model));
    }
    return *kept->second;
}

class Turntable {
public:
    explicit Turntable(const Scene& scene) : scene_{scene} {}

    Camera next(bool orthographic) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = azimuth_;
        cameraSettings.elevationAngle = 20.0;
        if (orthographic) cameraSettings.orthographicHeight = 0.0;
        azimuth_ += step;
        return frameCamera(scene_, cameraSettings, size);
    }
    MeshEye nextEye(bool orthographic) {
        const Camera camera = next(orthographic);
        const glm::dmat4 toWorld = glm::inverse(camera.view);
        return {orthographic, glm::dvec3{toWorld[3]} - scene_.meshes()[0].origin, -glm::dvec3{toWorld[2]}};
    }

private:
    const Scene& scene_;
    double azimuth_ = 0.0;
};

benchmark::internal::Benchmark* add(const std::string& name, std::function<void(benchmark::State&)> run) {
    return benchmark::RegisterBenchmark(name.c_str(), std::move(run))
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

void addView(Model model) {
    add("edge-table/" + nameOf(model), [model](benchmark::State& state) {
        const Scene& scene = prepared(model).scene;
        for (auto _ : state)
            benchmark::DoNotOptimize(
                findEdges(scene.meshes()[0], scene::topologyOf(scene, 0), scene.creaseAngle()).closed.data());
    });
    add("ray-tree/" + nameOf(model), [model](benchmark::State& state) {
        const Scene& scene = prepared(model).scene;
        for (auto _ : state) RayCaster rays{scene};
    });
    // Its stages are counters: milliseconds of wall time, the smallest of all views, which other work disturbs
    // smallest.
    add("object-lines/" + nameOf(model), [model](benchmark::State& state) {
        const Scene& scene = prepared(model).scene;
        const ObjectLines lines{scene};
        Turntable turntable{scene};
        Settings settings;
        settings.picture.size = size;
        (void)lines.find(turntable.next(false), settings);  // intersections are looked for once
        std::map<std::string, double> stages;
        std::size_t count = 0;
        for (auto _ : state) {
            const Lines found = lines.find(turntable.next(false), settings);
            for (const StageTime& time : found.times) {
                double& smallest = stages.try_emplace(time.stage, time.milliseconds).first->second;
                smallest = std::min(smallest, time.milliseconds);
            }
            count = found.lines.size();
        }
        for (const auto& [name, time] : stages) state.counters[name] = time;
        state.counters["lines_found"] = static_cast<double>(count);
    });
}

// Times views; says how many edges there are, how many of them a view finds, and what share of those that every finds
// it misses, by length.
void timeFinder(benchmark::State& state, Model model, ContourFinder finder) {
    const Prepared& of = prepared(model);
    const ContourSearch search{of.scene.meshes()[0], scene::topologyOf(of.scene, 0), of.edges};
    const Mesh& mesh = of.scene.meshes()[0];
    const bool orthographic = finder == ContourFinder::Gauss;
    const auto lengthOf = [&](const std::vector<std::uint32_t>& edges) {
        double sum = 0.0;
        for (const std::uint32_t e : edges) {
            const std::uint32_t h = of.edges.shared.halfEdges[e];
            sum += double{
                glm::distance(mesh.positions[mesh.indices[h]], mesh.positions[mesh.indices[mesh::nextHalfEdge(h)]])};
        }
        return sum;
    };
    search.prepare(finder);
    Turntable turntable{of.scene};
    ContourMemory memory;
    ContourMemory none;
    double found = 0.0;
    double expected = 0.0;
    double contours = 0.0;
    for (int warmUp = 0; warmUp < 3; ++warmUp) (void)search.find(turntable.nextEye(orthographic), finder, memory);
    for (auto _ : state) {
        state.PauseTiming();
        const MeshEye eye = turntable.nextEye(orthographic);
        state.ResumeTiming();
        const FoundContours contour = search.find(eye, finder, memory);
        state.PauseTiming();
        found += lengthOf(contour.edges);
        contours += static_cast<double>(contour.edges.size());
        expected += lengthOf(search.find(eye, ContourFinder::Every, none).edges);
        state.ResumeTiming();
    }
    state.counters["edges"] = static_cast<double>(of.edges.shared.halfEdges.size());
    state.counters["contour_edges"] = contours / static_cast<double>(state.iterations());
    state.counters["missed"] = 1.0 - found / expected;
}

void addFinders(Model model) {
    add(fmt::format("find/{}/every", nameOf(model)),
        [model](benchmark::State& state) { timeFinder(state, model, ContourFinder::Every); });
    add(fmt::format("find/{}/random", nameOf(model)),
        [model](benchmark::State& state) { timeFinder(state, model, ContourFinder::Random); });
    add(fmt::format("find/{}/gauss", nameOf(model)),
        [model](benchmark::State& state) { timeFinder(state, model, ContourFinder::Gauss); });
    for (const auto& [finder, name] :
         {std::pair{ContourFinder::Every, "every"}, std::pair{ContourFinder::Random, "random"},
          std::pair{ContourFinder::Gauss, "gauss"}}) {
        add(fmt::format("prepare-finder/{}/{}", nameOf(model), name), [model,
                                                                       finder = finder](benchmark::State& state) {
            const Prepared& of = prepared(model);
            std::size_t bytes = 0;
            for (auto _ : state)
                bytes = ContourSearch{of.scene.meshes()[0], scene::topologyOf(of.scene, 0), of.edges}.prepare(finder);
            state.counters["edges"] = static_cast<double>(of.edges.shared.halfEdges.size());
            state.counters["bytes"] = static_cast<double>(bytes);
        });
    }
    // The yardstick of every: one pass over the arrays that it reads.
    add("read-arrays/" + nameOf(model), [model](benchmark::State& state) {
        const MeshEdges& edges = prepared(model).edges;
        const std::size_t planes = edges.faceNormals.size() * 4 * sizeof(float);
        const std::size_t table = edges.shared.faces.size() * sizeof(std::uint32_t) + edges.shared.against.size();
        const std::vector<std::uint64_t> data((planes + table) / sizeof(std::uint64_t), 1);
        for (auto _ : state) {
            std::uint64_t all = 0;
            for (const std::uint64_t word : data) all ^= word;
            benchmark::DoNotOptimize(all);
        }
    });
}

}  // namespace
}  // namespace inkedge::benchmarks

int main(int count, char** arguments) {
    using namespace inkedge::benchmarks;
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    try {
        for (const Shape shape : shapes) {
            for (const std::uint64_t triangles : finderCounts) addFinders({shape, triangles});
            for (const std::uint64_t triangles : viewCounts) addView({shape, triangles});
        }
        benchmark::RunSpecifiedBenchmarks();
        benchmark::Shutdown();
    } catch (const std::exception& error) {
        fmt::print(stderr, "lines_benchmark: error: {}\n", error.what());
        return 1;
    }
}

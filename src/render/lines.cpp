#include "render/lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include <inkedge/error.h>

#include "gl/stage_clock.h"
#include "lines/describe.h"
#include "lines/see/rays.h"
#include "lines/specks.h"
#include "modules/open_module.h"
#include "render/needs_context.h"
#include "render/plan.h"
#include "render/tiles.h"
#include "trace/join_pieces.h"

namespace inkedge::render {

Image<std::uint8_t> shadeOf(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept,
                            std::vector<StageTime>& times) {
    Graphics& graphics = kept.graphics(times);
    const gl::Current current{graphics.context()};
    gl::StageClock clock{graphics.gpu().api, times};
    const passes::Frame frame = graphics.frame(scene, camera, settings.picture);
    clock.finish("upload");
    Tiles tiles = drawTiles(frame, graphics.inputs(), settings, planOfShade(settings), clock);
    graphics.gpu().textures.trim();
    return std::move(tiles.maps.shade);
}

void openRays() {
    if (!modules::failureToOpen(lines::embreeModule).empty()) return;
    // A first tree starts the library's threads and brings its code into memory.
    static constexpr std::array corners{glm::vec3{0.0F}, glm::vec3{1.0F, 0.0F, 0.0F}, glm::vec3{0.0F, 1.0F, 0.0F}};
    static constexpr std::array<std::uint32_t, 3> indices{0, 1, 2};
    const lines::RayMesh triangle{corners, 1.0, indices, std::span{indices}.first(1)};
    const lines::RayInstance instance{0, glm::mat4x3{1.0F}};
    static_cast<void>(
        modules::functionsOf<lines::embreeModule>(Error::Kind::Runtime).make({&triangle, 1}, {&instance, 1}));
}

Lines objectLines(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    std::vector<StageTime> before;
    gl::StageClock clock{before};
    const lines::ObjectLines& prepared = kept.objectLines(scene);
    clock.finish("prepare lines");
    Lines found = prepared.find(camera, settings);
    lines::leaveOutSpecks(found.lines);
    if (lines::leavesOutScraps(scene)) lines::leaveOutScraps(found.lines);
    lines::describe(found, scene, settings, LinesFrom::Object);
    found.backend = kept.backend();
    found.times.insert(found.times.begin(), before.begin(), before.end());
    return found;
}

namespace {

bool hasEdges(const Mesh& mesh, EdgeKind kind) {
    return std::ranges::any_of(mesh.edges, [&](EdgeKinds kinds) { return kinds.has(kind); });
}

}  // namespace

bool hasMarked(const Scene& scene) {
    return std::ranges::any_of(
        scene.meshes(), [](const Mesh& mesh) { return !mesh.lines.empty() || hasEdges(mesh, EdgeKind::Marked); });
}

bool hasTangent(const Scene& scene) {
    return std::ranges::any_of(scene.meshes(), [](const Mesh& mesh) { return hasEdges(mesh, EdgeKind::Tangent); });
}

Lines linesBesidePixels(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    const LineTypes drawn = settings.picture.lines;
    const bool marked = drawn.contains(LineType::Marked) && hasMarked(scene);
    const bool tangent = drawn.contains(LineType::Tangent) && hasTangent(scene);
    if (!marked && !tangent && (drawn & formLineTypes).empty()) return {};
    if (!modules::failureToOpen(lines::embreeModule).empty()) return {};
    RenderSettings seen = settings;
    seen.lines = LineSettings{};
    seen.lines.coincident = settings.lines.coincident;
    seen.lines.form = settings.lines.form;
    Lines found = kept.objectLines(scene).findBesidePixels(camera, seen);
    lines::leaveOutSpecks(found.lines);
    if (lines::leavesOutScraps(scene)) lines::leaveOutScraps(found.lines);
    return found;
}

Lines imageLines(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    Lines found;
    Graphics& graphics = kept.graphics(found.times);
    const gl::Current current{graphics.context()};
    gl::StageClock clock{graphics.gpu().api, found.times};
    const passes::Frame frame = graphics.frame(scene, camera, settings.picture);
    clock.finish("upload");
    if (settings.detector.detector != Detector::Planes) {
        throw Error{Error::Kind::Usage,
                    "lines from image: expected the planes detector, found another, which marks pixels and leaves no "
                    "lines; use --detector planes, or --lines-from object"};
    }
    const Tiles tiles = drawTiles(frame, graphics.inputs(), settings, planOfImageLines(), clock);
    found.lines = trace::joinPieces(tiles.pieces, scene, {camera, scene.bounds().centre, settings.picture.size});
    clock.finish("join");
    const Lines beside = linesBesidePixels(scene, camera, settings, kept);
    found.lines.insert(found.lines.end(), beside.lines.begin(), beside.lines.end());
    if (!beside.lines.empty()) clock.finish("lines of the mesh");
    graphics.gpu().textures.trim();
    found.size = settings.picture.size;
    found.camera = camera;
    lines::leaveOutSpecks(found.lines);
    lines::describe(found, scene, settings, LinesFrom::Image);
    found.backend = kept.backend();
    return found;
}

}  // namespace inkedge::render

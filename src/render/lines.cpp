#include "render/lines.h"

#include <algorithm>
#include <utility>

#include <inkedge/error.h>

#include "gl/stage_clock.h"
#include "lines/describe.h"
#include "lines/join_pieces.h"
#include "render/plan.h"
#include "render/tiles.h"

namespace inkedge {
namespace {

// The face that a triangle of the scene is.
SceneFace faceOf(std::uint32_t triangle, const std::vector<std::uint32_t>& firstTriangles) {
    const auto after = std::ranges::upper_bound(firstTriangles, triangle);
    const auto instance = static_cast<std::uint32_t>(after - firstTriangles.begin()) - 1;
    return {instance, triangle - firstTriangles[instance]};
}

std::vector<Line> joined(const TracedLines& traced, const Frame& frame, Size size) {
    const lines::Screen screen{frame.camera, frame.scene.bounds().centre, size};
    std::vector<lines::TracedPiece> pieces;
    pieces.reserve(traced.strokes.size());
    for (std::size_t i = 0; i < traced.strokes.size(); ++i) {
        const Stroke& stroke = traced.strokes[i];
        const StrokeSurface& surface = traced.surfaces[i];
        pieces.push_back({{stroke.from, stroke.to},
                          {double{surface.inverseDepthFrom}, double{surface.inverseDepthTo}},
                          static_cast<LineType>(1U << stroke.pen),
                          faceOf(surface.triangle - 1, frame.upload.firstTriangles())});
    }
    return lines::joinPieces(pieces, frame.scene, screen);
}

}  // namespace

Lines objectLines(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    std::vector<StageTime> before;
    gl::StageClock clock{before};
    const lines::ObjectLines& prepared = kept.objectLines(scene);
    clock.finish("prepare lines");
    Lines found = prepared.find(camera, settings);
    lines::describe(found, scene, settings, LinesFrom::Object);
    found.backend = kept.backend();
    found.times.insert(found.times.begin(), before.begin(), before.end());
    return found;
}

Lines imageLines(const Scene& scene, const Camera& camera, const RenderSettings& settings, Kept& kept) {
    Lines found;
    Graphics& graphics = kept.graphics(found.times);
    const gl::Current current{graphics.context()};
    gl::StageClock clock{graphics.gpu().api, found.times};
    const Frame frame = graphics.frame(scene, camera, settings.picture);
    clock.finish("upload");
    if (settings.detector.detector != Detector::Planes) {
        throw Error{Error::Kind::Usage,
                    "lines from image: expected the planes detector, found another, which marks pixels and leaves no "
                    "lines; use --detector planes, or --lines-from object"};
    }
    const Tiles tiles = drawTiles(frame, graphics.inputs(), settings, planOfImageLines(), clock);
    found.lines = joined(tiles.traced, frame, settings.picture.size);
    clock.finish("join");
    graphics.gpu().textures.trim();
    found.size = settings.picture.size;
    found.camera = camera;
    lines::describe(found, scene, settings, LinesFrom::Image);
    found.backend = kept.backend();
    return found;
}

}  // namespace inkedge

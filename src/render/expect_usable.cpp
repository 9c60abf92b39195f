#include "render/expect_usable.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "raster/memory.h"
#include "render/plan.h"

namespace inkedge::render {
namespace {

// The bytes per pixel that the picture and the maps take.
std::uint64_t bytesPerPixel(const RenderSettings& settings) {
    std::uint64_t bytes = settings.picture.background ? 3 : 4;
    const std::pair<Map, std::uint64_t> costs[]{{Map::Depth, 8},       {Map::Normal, 12}, {Map::DepthEdges, 5},
                                                {Map::NormalEdges, 5}, {Map::Edges, 1},   {Map::Types, 2},
                                                {Map::Ids, 16}};
    for (const auto& [map, cost] : costs) bytes += wants(settings, map) ? cost : 0;
    if (!settings.detector.functions.empty() || settings.detector.detector == Detector::SaitoTakahashi) ++bytes;  // ink
    const StyleRow& style = styleRow(settings.style.style);
    if (style.tileInk != nullptr) ++bytes;
    if (style.redraw != nullptr) bytes += 8;  // the drawing, and the picture that is drawn from it
    return bytes;
}

}  // namespace

void expectUsable(const Camera& camera) {
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

void expectLoaded(const Scene& scene, const RenderSettings& settings) {
    Settings all;
    static_cast<RenderSettings&>(all) = settings;
    const LoadSettings needed = loadSettings(all);
    const LoadSettings& loaded = scene.loadedWith();
    if (scene.source().format.empty()) {  // its coordinates and colours are those that it was given
        if (!needed.curvature || loaded.curvature) return;
        throw Error{Error::Kind::Usage,
                    "scene: expected one made with its curvature, which functions read, found one made without; make "
                    "it with Scene{data, loadSettings(settings)}"};
    }
    const auto expect = [](bool isNeeded, bool isLoaded, std::string_view what) {
        if (!isNeeded || isLoaded) return;
        throw Error{
            Error::Kind::Usage,
            fmt::format("scene: expected one loaded with {}, which functions or isolines read, found one loaded "
                        "without; load it with loadScene(file, loadSettings(settings))",
                        what)};
    };
    expect(needed.textureCoordinates, loaded.textureCoordinates, "its texture coordinates");
    expect(needed.paint, loaded.paint, "its colours");
    expect(needed.curvature, loaded.curvature, "its curvature");
}

void expectMemory(const RenderSettings& settings) {
    raster::expectMemory(settings.picture.size, bytesPerPixel(settings));
}

}  // namespace inkedge::render

#include "render/expect_usable.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/error.h>

#include "raster/memory.h"
#include "render/plan.h"
#include "settings/idle.h"
#include "settings/shades.h"

namespace inkedge::render {
namespace {

// The bytes per pixel that the picture and the maps take.
std::uint64_t bytesPerPixel(const RenderSettings& settings) {
    std::uint64_t bytes = settings.picture.background ? 3 : 4;
    const std::pair<Map, std::uint64_t> costs[]{{Map::Depth, 8},       {Map::Normal, 12}, {Map::DepthEdges, 5},
                                                {Map::NormalEdges, 5}, {Map::Edges, 1},   {Map::Types, 2},
                                                {Map::Ids, 16}};
    for (const auto& [map, cost] : costs) bytes += wants(settings, map) ? cost : 0;
    if (!settings.detector.functions.empty() || settings.detector.detector == Detector::SaitoTakahashi ||
        settings.detector.detector == Detector::RaskarCohen)
        ++bytes;  // ink
    const StyleRow& style = styleRow(settings.style.style);
    if (style.tileInk != nullptr) ++bytes;
    if (style.redraw != nullptr) bytes += 8;  // the drawing, and the picture that is drawn from it
    if (settings::drawnShade(settings) != Shade::None) bytes += 4;
    if (settings.shade.shade != Shade::None) bytes += 8;  // the drawing, and the picture of both
    return bytes;
}

// What lies further off, or is looked at more closely, is beyond the numbers that pictures are drawn with.
void expectWithinReach(const Camera& camera, const Sphere& bounds) {
    constexpr double farthest = 1e7;  // radii
    constexpr double lowest = 1e-9;   // of the radius
    if (bounds.radius == 0.0) return;
    // A model far from the world's origin has no eye that is known to its own size.
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * glm::length(bounds.centre) / bounds.radius;
    const double distance = glm::distance(glm::dvec3{glm::inverse(camera.view)[3]}, bounds.centre) / bounds.radius;
    if (!(distance <= farthest + rounding))
        throw Error{Error::Kind::Usage, fmt::format("camera: expected an eye within {} radii of the model's middle, "
                                                    "found one at {:.3g}; stand nearer",
                                                    farthest, distance)};
    const double height = camera.orthographic()
                              ? camera.orthographicHeight / bounds.radius
                              : 2.0 * std::tan(glm::radians(camera.viewAngle) / 2.0) * std::max(distance, 1.0);
    if (!(height >= lowest))
        throw Error{Error::Kind::Usage,
                    fmt::format("camera: expected a view at least {} radii of the model tall, found "
                                "{:.3g}; zoom out",
                                lowest, height)};
}

}  // namespace

void expectUsable(const Camera& camera, const Scene& scene) {
    const bool angleUsable = camera.orthographic() || (camera.viewAngle > 0.0 && camera.viewAngle < 180.0);
    const bool depthsUsable = camera.near < camera.far && (camera.orthographic() || camera.near > 0.0);
    const bool finite = std::isfinite(camera.near) && std::isfinite(camera.far) && camera.pixelAspect > 0.0 &&
                        std::isfinite(1.0 / camera.pixelAspect) && std::isfinite(glm::determinant(camera.view));
    if (!angleUsable || !depthsUsable || !finite) {
        throw Error{
            Error::Kind::Usage,
            fmt::format("camera: expected a view angle over 0 and under 180 and 0 < near < far, all finite, found "
                        "{} and {}, {}",
                        camera.viewAngle, camera.near, camera.far)};
    }
    expectWithinReach(camera, scene.bounds());
}

void expectLoaded(const Scene& scene, const RenderSettings& settings, const OutputKinds& kinds) {
    Settings all;
    static_cast<RenderSettings&>(all) = settings;
    const LoadSettings needed = loadSettings(all);
    const LoadSettings& loaded = scene.loadedWith();
    if (!loaded.completeNormals && settings::readsVertexNormals(all, kinds)) {
        throw Error{
            Error::Kind::Usage,
            "scene: expected one with a normal at every vertex, which lines of the mesh, shades, styles and maps "
            "of normals read, found one loaded without LoadSettings::completeNormals"};
    }
    if (scene.source().format.empty()) {  // its coordinates and colours are those that it was given
        if (!needed.curvature || loaded.curvature) return;
        throw Error{Error::Kind::Usage,
                    "scene: expected one made with its curvature, which functions read, found one made without; give "
                    "the settings that draw it to what makes it, too: in C++ loadSettings(settings)"};
    }
    const auto expect = [](bool isNeeded, bool isLoaded, std::string_view what) {
        if (!isNeeded || isLoaded) return;
        throw Error{
            Error::Kind::Usage,
            fmt::format("scene: expected one loaded with {}, which shades, functions or isolines read, found one "
                        "loaded without; give the settings that draw it to what loads it, too: in C++ "
                        "loadSettings(settings)",
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

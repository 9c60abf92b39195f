// How far triangles stray from the surfaces of CAD files.
#include <array>
#include <numbers>
#include <utility>

#include <inkedge/views.h>

#include "formats/cad/cad_scenes.h"

namespace inkedge::cad {
namespace {

// The largest distance of triangles from the surface, in pixels of one of the views.
double errorOf(const Known& known, const Scene& scene, const LoadSettings& settings) {
    const Mesh& mesh = scene.meshes().front();
    double worst = 0.0;
    for (const CameraSettings& view : settings.pictures.cameras) {
        const Size size = settings.pictures.picture.size;
        const Camera camera = frameCamera(scene, view, size);
        for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
            const glm::dvec3 middle = (position(mesh, c) + position(mesh, c + 1) + position(mesh, c + 2)) / 3.0;
            const double depth = -(camera.view * glm::dvec4{middle, 1.0}).z;
            const double height = camera.orthographic()
                                      ? camera.orthographicHeight
                                      : 2.0 * depth * std::tan(0.5 * camera.viewAngle * std::numbers::pi / 180.0);
            if (depth < camera.near) continue;
            worst = std::max(worst, std::abs(known.distance(middle)) * size.height / height);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 edge = 0.5 * (position(mesh, c + k) + position(mesh, c + (k + 1) % 3));
                worst = std::max(worst, std::abs(known.distance(edge)) * size.height / height);
            }
        }
    }
    return worst;
}

LoadSettings forViews(std::vector<CameraSettings> views, Size size) {
    LoadSettings settings;
    settings.pictures.cameras = std::move(views);
    settings.pictures.picture.size = size;
    return settings;
}

TEST(Tessellation, straysFromSurfacesByNoMoreThanTheTolerance) {
    CameraSettings iso;
    iso.view = NamedView::Iso;
    CameraSettings near;
    near.position = glm::dvec3{30, 5, 5};
    near.focalPoint = glm::dvec3{0, 0, 0};
    const std::vector<std::pair<std::string, LoadSettings>> views{{"framed", forViews({{}}, {640, 480})},
                                                                  {"large", forViews({{}}, {1600, 1600})},
                                                                  {"orthographic", forViews({iso}, {800, 800})},
                                                                  {"from a position", forViews({near}, {600, 600})},
                                                                  {"several", forViews({{}, iso, near}, {600, 600})}};
    for (const Known& known : known()) {
        for (const auto& [name, settings] : views) {
            if (known.shape == Shape::OffsetTorus && name != "framed") continue;  // for speed
            for (const double tolerance : {0.25, 2.0}) {
                LoadSettings with = settings;
                with.tolerance = tolerance;
                const double error = errorOf(known, sceneOf(known.shape, with), with);
                EXPECT_LE(error, 1.1 * tolerance) << name << static_cast<int>(known.shape);
            }
        }
    }
}

// The Delabella algorithm crashes over it.
TEST(Tessellation, fillsACornerOutsideACircle) {
    LoadSettings settings = forViews({{}}, {512, 512});
    settings.tolerance = 0.04;
    const Scene scene = sceneOf(Shape::Corner, settings);
    const double turn = std::acos(9.5 / 9.51);
    const double sector = 0.5 * 9.51 * 9.51 * (std::numbers::pi / 2.0 - 2.0 * turn);
    const double triangles = 9.5 * std::sqrt(9.51 * 9.51 - 9.5 * 9.5);
    const double rounding = 0.4 * 0.4 * (1.0 - std::numbers::pi / 4.0);
    EXPECT_NEAR(areaOf(scene.meshes().front()), 9.5 * 9.5 - sector - triangles - rounding, 0.05)
        << "but for what chords of the circle miss";
}

TEST(Tessellation, followsTheSizeOfThePicture) {
    const auto triangles = [](const LoadSettings& settings) { return sceneOf(Shape::Torus, settings).triangleCount(); };
    const std::uint64_t small = triangles(forViews({{}}, {100, 100}));
    const std::uint64_t large = triangles(forViews({{}}, {800, 800}));
    EXPECT_GT(large, 3 * small) << "8 times as many pixels a side take about 8 times as many triangles";
    EXPECT_LT(large, 30 * small);
}

TEST(Tessellation, takesNoTimeForWhatNoPictureShows) {
    CameraSettings beside;
    beside.position = glm::dvec3{30, 0, 0};
    beside.focalPoint = glm::dvec3{60, 0, 0};
    EXPECT_LT(sceneOf(Shape::Torus, forViews({beside}, {800, 800})).triangleCount(),
              sceneOf(Shape::Torus, forViews({{}}, {800, 800})).triangleCount() / 4);
}

}  // namespace
}  // namespace inkedge::cad

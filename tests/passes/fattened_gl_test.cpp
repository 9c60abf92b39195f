// Lines by enlarged back faces and fins: Raskar and Cohen 1999, Raskar 2001.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>

#include <inkedge/setting_table.h>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "passes/draw_fattened.h"
#include "scene/face_edges.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

INKEDGE_ON_EACH_BACKEND(Fattened);

constexpr Size size{128, 96};

Settings settingsOf(double width, Size picture = size) {
    Settings settings;
    settings.picture.size = picture;
    settings.picture.lineWidth.value = width;
    settings.detector.detector = Detector::RaskarCohen;
    settings.maps = {Map::Edges};
    return settings;
}

Camera cameraFor(const Scene& scene, double azimuth, double elevation, bool orthographic) {
    CameraSettings settings;
    settings.azimuthAngle = azimuth;
    settings.elevationAngle = elevation;
    if (orthographic) settings.orthographicHeight = 0.0;
    return frameCamera(scene, settings, size);
}

glm::dmat4 mirrored(glm::dvec3 at) {
    glm::dmat4 transform = scenes::rotation(20, {0, 1, 0});
    transform[0] = -transform[0];
    transform[3] = glm::dvec4{at, 1.0};
    return transform;
}

// Solids, one of them mirrored, and an open sheet.
Scene mixedScene() {
    return scenes::sceneOf(
        {{scenes::sphere(1.0, 24), scenes::translation({-0.8, 0.3, 0.5})},
         {scenes::box({2, 1, 1.5}), scenes::rotation(30, {1, 2, 0})},
         {scenes::box({0.6, 1.2, 0.8}), mirrored({1.8, 0.2, -0.5})},
         {scenes::quad({-2, -1.4, 1}, {0, -1.4, 1.2}, {0, -0.6, 1.6}, {-2, -0.6, 1.4}), glm::dmat4{1.0}}});
}

TEST_P(Fattened, equalsItsDefinition) {
    const gl::Current current{context()};
    const Scene scene = mixedScene();
    const gl::UploadedScene upload{gpu().api, scene};
    gl::FunctionInputs inputs{gpu().api};
    for (const double width : {1.0, 3.0}) {
        for (const bool orthographic : {false, true}) {
            for (const double azimuth : {25.0, 160.0}) {
                SCOPED_TRACE(testing::Message() << width << ", " << azimuth << (orthographic ? ", orthographic" : ""));
                const Camera camera = cameraFor(scene, azimuth, 20.0, orthographic);
                const Image<std::uint8_t> expected = reference::drawFattened(scene, camera, width, size);
                const Image<std::uint8_t> found =
                    drawFattened(frameOf(gpu(), upload, scene, camera, size), inputs, width);
                const auto inked = std::ranges::count(expected.pixels(), 255);
                EXPECT_GT(inked, width == 1.0 ? 200 : 1000);
                long differing = 0;
                for (std::size_t i = 0; i < found.pixels().size(); ++i)
                    differing += found.pixels()[i] != expected.pixels()[i] ? 1 : 0;
                // Vertices are rounded to 1/256 pixel, and strips end at the middle of pixels: about one in a hundred.
                EXPECT_LE(differing, inked / 50);
            }
        }
    }
}

// The ink along a row of pixels, of which one silhouette is crossed between columns.
int inkBetween(const Image<std::uint8_t>& edges, int y, int from, int to) {
    int count = 0;
    for (int x = from; x < to; ++x) count += edges.at(x, y) != 0 ? 1 : 0;
    return count;
}

TEST_P(Fattened, hasSilhouettesOfConstantWidthWhateverTheDistance) {
    // Two balls of one size, one of them four times as far off.
    const Scene scene = scenes::sceneOf({{scenes::sphere(1.0, 96), scenes::translation({-1.2, 0, 0})},
                                         {scenes::sphere(1.0, 96), scenes::translation({3.0, 0, -12})}});
    Camera camera;
    camera.view = scenes::translation({0, 0, -5});
    camera.viewAngle = 40.0;
    camera.near = 1.0;
    camera.far = 40.0;
    constexpr Size large{400, 300};
    for (const double width : {2.0, 5.0}) {
        const Image<std::uint8_t> edges = renderer().render(scene, camera, settingsOf(width, large)).edges;
        // Along the row through the balls' middle: each ball has ink on its left and on its right.
        EXPECT_NEAR(inkBetween(edges, 150, 0, 240), 2 * width, 1.0) << "the near ball";
        EXPECT_NEAR(inkBetween(edges, 150, 240, 400), 2 * width, 1.0) << "the far ball";
    }
}

TEST_P(Fattened, hasRidgesAndValleysByTheCreaseAngle) {
    // A step: from above a ridge and a valley across the whole width, within its silhouette.
    Mesh step;
    step.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {1, 1, -1}, {-1, 1, -1}};
    step.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 5, 4, 6, 5, 6, 7};
    const auto creaseInk = [&](double angle) {
        LoadSettings load;
        load.creaseAngle = angle;
        load.creases = Creases::Angle;
        const Scene scene = scenes::sceneOf({{step, glm::dmat4{1.0}}}, load);
        const Camera camera = cameraFor(scene, 0.0, 45.0, true);
        const Image<std::uint8_t> edges = renderer().render(scene, camera, settingsOf(2.0)).edges;
        int count = 0;  // in the middle column
        for (int y = 0; y < size.height; ++y) count += edges.at(size.width / 2, y) != 0 ? 1 : 0;
        return count;
    };
    // Two borders of two pixels, and two creases.
    EXPECT_NEAR(creaseInk(60.0), 8, 1);
    EXPECT_NEAR(creaseInk(120.0), 4, 1);
}

TEST_P(Fattened, showsNoLinesWithinSmoothSurfaces) {
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 48));
    const Camera camera = cameraFor(scene, 30.0, 20.0, false);
    const Image<std::uint8_t> edges = renderer().render(scene, camera, settingsOf(2.0)).edges;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool inside = std::hypot(x - 63.5, y - 47.5) < 40.0;
            EXPECT_FALSE(inside && edges.at(x, y) != 0) << x << ", " << y;
        }
    }
    EXPECT_GT(std::ranges::count(edges.pixels(), 255), 200);
}

TEST_P(Fattened, goesOnAcrossBordersThatRunAlongEachOther) {
    // A square in two halves that share no vertex, the second one in two pieces along the first.
    const Mesh left = scenes::quad({-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    const Mesh below = scenes::quad({0, -1, 0}, {1, -1, 0}, {1, 0.1, 0}, {0, 0.1, 0});
    const Mesh above = scenes::quad({0, 0.1, 0}, {1, 0.1, 0}, {1, 1, 0}, {0, 1, 0});
    const Scene scene = scenes::sceneOf({{left, glm::dmat4{1.0}}, {below, glm::dmat4{1.0}}, {above, glm::dmat4{1.0}}});
    const Camera camera = cameraFor(scene, 0.0, 0.0, true);
    const Image<std::uint8_t> edges = renderer().render(scene, camera, settingsOf(2.0)).edges;
    EXPECT_EQ(inkBetween(edges, size.height / 2 + 10, 40, 88), 0) << "along the seam and beside it";
    EXPECT_GT(std::ranges::count(edges.pixels(), 255), 100);
}

TEST_P(Fattened, inTilesIsTheSame) {
    const Scene scene = mixedScene();
    constexpr Size large{600, 400};
    Settings settings = settingsOf(3.0, large);
    settings.picture.supersampling = 2;
    const Camera camera = frameCamera(scene, {}, large);
    const Image<std::uint8_t> whole = renderer().render(scene, camera, settings).picture;
    settings.picture.tileSize = 256;
    const Image<std::uint8_t> tiled = renderer().render(scene, camera, settings).picture;
    long differing = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i)
        differing += std::abs(whole.pixels()[i] - tiled.pixels()[i]) > 64 ? 1 : 0;
    EXPECT_LE(differing, 5) << "strips are rounded to the grid of vertices in each tile anew";
}

TEST(FaceEdges, sayWhatLiesBeyond) {
    const Scene cube = scenes::sceneOf(scenes::cube());
    const std::vector<scene::FaceEdges> faces = scene::faceEdgesOf(cube);
    ASSERT_EQ(faces.size(), 12U);
    int creases = 0;
    for (std::uint32_t t = 0; t < faces.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            creases += faces[t].has(scene::EdgeFlag::Crease, k) ? 1 : 0;
            ASSERT_LT(faces[t].beyond[k], faces.size());
            EXPECT_THAT(faces[faces[t].beyond[k]].beyond, testing::Contains(t));
            EXPECT_FALSE(faces[t].has(scene::EdgeFlag::Border, k));
        }
        EXPECT_GT(faces[t].plane.w, 0.0F) << "normals point away from the middle";
    }
    EXPECT_EQ(creases, 24) << "twelve edges, seen from both sides";
}

}  // namespace
}  // namespace inkedge::passes

// Pictures drawn in tiles equal those drawn in one piece.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <inkedge/load_scene.h>

#include "gl/gl_test.h"
#include "raster/tiles.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

INKEDGE_ON_EACH_BACKEND(Tiling);

Scene asset(const std::string& name) { return loadScene(INKEDGE_SOURCE_DIR "/assets/" + name + ".glb"); }

const std::vector<Map> allMaps{Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges,
                               Map::Edges, Map::Types,  Map::Ids};

// The same picture by the smallest tiles, whose number along each axis is at least three, and in one piece.
struct Both {
    Maps whole;
    Maps tiled;
};
Both drawBoth(Renderer& renderer, const Scene& scene, Settings settings, CameraSettings cameraSettings = {}) {
    cameraSettings.azimuthAngle = 33.0;
    cameraSettings.elevationAngle = 21.0;
    const Camera camera = frameCamera(scene, cameraSettings, settings.picture.size);
    settings.picture.tileSize = PictureSettings::maxTileSize;
    Maps whole = renderer.render(scene, camera, settings);
    settings.picture.tileSize = PictureSettings::minTileSize;
    return {std::move(whole), renderer.render(scene, camera, settings)};
}

template <class T>
std::size_t differing(const Image<T>& a, const Image<T>& b) {
    if (a.size() != b.size() || a.channels() != b.channels()) return a.pixels().size() + b.pixels().size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i] != b.pixels()[i] ? 1 : 0;
    return count;
}

// The largest difference, as a share of the largest value.
double distance(const Image<float>& a, const Image<float>& b) {
    EXPECT_EQ(a.size(), b.size());
    double difference = 0.0;
    double largest = 1e-30;
    for (std::size_t i = 0; i < std::min(a.pixels().size(), b.pixels().size()); ++i) {
        difference =
            std::max(difference, std::abs(static_cast<double>(a.pixels()[i]) - static_cast<double>(b.pixels()[i])));
        largest = std::max(largest, std::abs(static_cast<double>(a.pixels()[i])));
    }
    return difference / largest;
}

void expectSame(const Both& both) {
    EXPECT_EQ(both.whole.picture.size(), both.tiled.picture.size());
    EXPECT_EQ(differing(both.whole.picture, both.tiled.picture), 0);
    EXPECT_EQ(differing(both.whole.edges, both.tiled.edges), 0);
    EXPECT_EQ(differing(both.whole.depthEdges, both.tiled.depthEdges), 0);
    EXPECT_EQ(differing(both.whole.normalEdges, both.tiled.normalEdges), 0);
    EXPECT_EQ(differing(both.whole.types, both.tiled.types), 0);
    EXPECT_EQ(differing(both.whole.ids, both.tiled.ids), 0);
    // Drivers interpolate from the target's corner, so that the last bits are each tile's own: of normals those of
    // small triangles, 6e-5 on llvmpipe.
    constexpr double rounding = 2e-4;
    EXPECT_LT(distance(both.whole.depth, both.tiled.depth), rounding);
    EXPECT_LT(distance(both.whole.windowDepth, both.tiled.windowDepth), rounding);
    EXPECT_LT(distance(both.whole.normal, both.tiled.normal), rounding);
    EXPECT_LT(distance(both.whole.depthMagnitude, both.tiled.depthMagnitude), rounding);
    EXPECT_LT(distance(both.whole.normalMagnitude, both.tiled.normalMagnitude), rounding);
}

TEST_P(Tiling, changesNoPixelOfPlanesLines) {
    for (const std::string name : {"gear", "teapot", "bracket", "torus_knot"}) {
        SCOPED_TRACE(name);
        Settings settings;
        settings.picture.size = {420, 400};
        settings.maps = {Map::Edges, Map::Types, Map::Ids};
        const Scene scene = asset(name);
        expectSame(drawBoth(renderer(), scene, settings));
        settings.picture.lineWidth = {9.0, false};  // reaches over the tiles' borders
        settings.maps.clear();
        CameraSettings orthographic;
        orthographic.orthographicHeight = 0.0;
        expectSame(drawBoth(renderer(), scene, settings, orthographic));
    }
}

TEST_P(Tiling, changesNoPixelOfSupersampledLines) {
    for (const int samples : {2, 4}) {
        Settings settings;
        settings.picture.size = {301, 270};
        settings.picture.supersampling = samples;
        settings.picture.background = std::nullopt;
        settings.maps = allMaps;
        expectSame(drawBoth(renderer(), asset("gear"), settings));
    }
}

TEST_P(Tiling, changesNoPixelOfClassicEdges) {
    for (const std::string name : {"gear", "teapot"}) {
        SCOPED_TRACE(name);
        const Scene scene = asset(name);
        for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
            Settings settings = gl_test::classic({420, 400}, allMaps);
            settings.detector.kernel = kernel;
            expectSame(drawBoth(renderer(), scene, settings));
        }
        Settings settings = gl_test::classic({420, 400});
        settings.detector.normalLights = NormalLights::TwoPass;
        expectSame(drawBoth(renderer(), scene, settings));
    }
}

// Where two surfaces are equally near, or two faces meet at just the crease angle (30 degrees on grazing_plane's
// sphere), the rounding of interpolation decides, and each tile has its own: 0 to 25 pixels of these on llvmpipe.
TEST_P(Tiling, changesFewPixelsWhereRoundingDecides) {
    for (const std::string name : {"touching_solids", "grazing_plane"}) {
        SCOPED_TRACE(name);
        Settings settings;
        settings.picture.size = {600, 560};
        const Both both = drawBoth(renderer(), asset(name), settings);
        EXPECT_LE(differing(both.whole.picture, both.tiled.picture), 100);
    }
}

// An orthographic camera that is moved aside by whole pixels sees what lies there in a wider picture. It projects by
// other floats, so that vertices may come to lie on other points of the rasteriser's grid, 1/256 pixel beside: the ink
// then differs by 1/256 of its darkness for each, and by more where a whole sample changes sides.
TEST_P(Tiling, drawsPicturesThatAreLongerThanAnyTarget) {
    std::vector<std::pair<Mesh, glm::dmat4>> boxes;
    for (int i = 0; i < 60; ++i) {
        const glm::dmat4 moved = scenes::translation({i * 3.3 - 98.0, 0.0, 0.0});
        boxes.emplace_back(scenes::box({1.0 + 0.01 * i, 1.5, 1.0}),
                           moved * scenes::rotation(7.0 * i + 11.0, {1.0, 2.0, 0.5}));
    }
    const Scene scene = scenes::sceneOf(boxes);
    Settings settings;
    settings.picture.size = {20000, 300};
    CameraSettings cameraSettings;
    cameraSettings.orthographicHeight = 3.0;
    cameraSettings.direction = glm::dvec3{0, 0, -1};
    cameraSettings.focalPoint = glm::dvec3{0, 0, 0};
    const Camera camera = frameCamera(scene, cameraSettings, settings.picture.size);
    const Image<std::uint8_t> wide = renderer().render(scene, camera, settings).picture;
    ASSERT_EQ(wide.size(), (Size{20000, 300}));

    Settings piece = settings;
    piece.picture.size = {1000, 300};
    for (const int x : {0, 3600, 8000, 16000, 19000}) {
        SCOPED_TRACE(x);
        Camera aside = camera;
        const double pixelsAside = x + 500 - 10000;
        aside.view = scenes::translation({-pixelsAside * 3.0 / 300.0, 0.0, 0.0}) * camera.view;
        const Image<std::uint8_t> there = renderer().render(scene, aside, piece).picture;
        int inked = 0;
        int different = 0;
        for (int row = 0; row < 300; ++row) {
            for (int column = 20; column < 980; ++column) {  // strokes are carried on beyond a picture's edge
                inked += there.at(column, row) < 255 ? 1 : 0;
                different += std::abs(there.at(column, row) - wide.at(x + column, row)) > 4 ? 1 : 0;
            }
        }
        EXPECT_GT(inked, 3000);
        EXPECT_LE(different, inked / 200);
    }
}

}  // namespace
}  // namespace inkedge::render

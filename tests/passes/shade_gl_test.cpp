// What lies under the lines: shaders/draw_shade.frag against its definition, and pictures with it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include <inkedge/setting_table.h>

#include "reference/reference.h"

#include "camera/light.h"
#include "gl/gl_test.h"
#include "passes/draw_shade.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

INKEDGE_ON_EACH_BACKEND(Shades);

constexpr Size size{96, 72};

// A ball in two colours, a turned box and a mirrored one.
Scene colorfulScene() {
    Mesh ball = scenes::sphere(1.0, 48);
    for (const glm::vec3& p : ball.positions)
        ball.paint.push_back({p.y > 0.0F ? glm::vec4{0.8F, 0.2F, 0.05F, 1.0F} : glm::vec4{0.1F, 0.4F, 0.9F, 1.0F}, {}});
    glm::dmat4 mirror = scenes::rotation(20, {0, 1, 0});
    mirror[0] = -mirror[0];
    mirror[3] = glm::dvec4{1.6, 0.2, -0.5, 1.0};
    LoadSettings load;
    load.paint = true;
    return scenes::sceneOf({{ball, scenes::translation({-0.8, 0.3, 0.5})},
                            {scenes::box({2, 1, 1.5}), scenes::rotation(30, {1, 2, 0})},
                            {scenes::box({0.6, 1.2, 0.8}), mirror}},
                           load);
}

Camera cameraFor(const Scene& scene, bool orthographic) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 25.0;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return frameCamera(scene, cameraSettings, size);
}

TEST_P(Shades, equalTheirDefinition) {
    const gl::Current current{context()};
    const Scene scene = colorfulScene();
    const gl::UploadedScene upload{gpu().api, scene};
    gl::FunctionInputs inputs{gpu().api};
    for (const bool orthographic : {false, true}) {
        const Camera camera = cameraFor(scene, orthographic);
        for (const Shade shade : {Shade::Flat, Shade::Gooch, Shade::Light, Shade::BaseColor}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(shade) << (orthographic ? ", orthographic" : ""));
            const glm::dvec3 light = camera::towardsLight(scene, camera, {-50.0, 25.0}, LightSpace::Camera);
            const Image<double> expected = reference::drawShade(scene, camera, shade, light, size);
            const Image<std::uint8_t> found =
                drawShade(frameOf(gpu(), upload, scene, camera, size), inputs, shade, light, 1);
            int covered = 0;
            int far = 0;
            int pixels = 0;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const bool there = expected.at(x, y, 3) > 0.0;
                    if (there != (found.at(x, y, 3) > 0)) {
                        ++covered;
                        continue;
                    }
                    pixels += there ? 1 : 0;
                    double worst = 0.0;
                    for (int c = 0; c < 4; ++c)
                        worst = std::max(worst, std::abs(found.at(x, y, c) - 255.0 * expected.at(x, y, c)));
                    far += worst > 1.0 ? 1 : 0;  // 8 bits round by half a step
                }
            }
            EXPECT_GT(pixels, 1000);
            EXPECT_LE(covered, 12) << "pixels whose centre lies within the grid of vertices of an edge";
            EXPECT_LE(far, 25) << "pixels on edges between triangles: either may be drawn";
        }
    }
}

TEST(Light, comesFromOverTheShoulderOrFromTheFront) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const auto expectNear = [](glm::dvec3 found, glm::dvec3 expected) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
    };
    CameraSettings settings;
    settings.azimuthAngle = 90.0;
    settings.elevationAngle = 0.0;
    const Camera fromTheRight = frameCamera(scene, settings, size);
    expectNear(camera::towardsLight(scene, fromTheRight, {0.0, 0.0}, LightSpace::Camera), {0, 0, 1});
    expectNear(camera::towardsLight(scene, fromTheRight, {90.0, 0.0}, LightSpace::Camera), {1, 0, 0});
    expectNear(camera::towardsLight(scene, fromTheRight, {0.0, 90.0}, LightSpace::Camera), {0, 1, 0});
    expectNear(camera::towardsLight(scene, fromTheRight, {90.0, 0.0}, LightSpace::World), {0, 0, 1});
    expectNear(camera::towardsLight(scene, fromTheRight, {0.0, 0.0}, LightSpace::World), {-1, 0, 0});
}

Settings shaded(const char* shade, std::vector<Map> maps = {}) {
    Settings settings;
    settings.picture.size = size;
    settings.maps = std::move(maps);
    set(settings, "shade", shade, "test");
    return settings;
}

TEST_P(Shades, lieUnderTheLines) {
    const Scene scene = colorfulScene();
    const Camera camera = cameraFor(scene, false);
    const Image<std::uint8_t> lines = renderer().render(scene, camera, shaded("none")).picture;
    ASSERT_EQ(lines.channels(), 1);
    const Maps maps = renderer().render(scene, camera, shaded("gooch", {Map::Shade}));
    ASSERT_EQ(maps.picture.channels(), 3);
    ASSERT_EQ(maps.shade.channels(), 4);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double under = maps.shade(x, y, 3) == 0 ? 255.0 : maps.shade(x, y, 2);
            // Black ink takes away what it covers; two roundings to 8 bits.
            EXPECT_NEAR(maps.picture.at(x, y, 2), under * lines.at(x, y) / 255.0, 2.0) << x << ", " << y;
        }
    }
}

TEST_P(Shades, areAMapByThemselves) {
    const Scene scene = colorfulScene();
    const Camera camera = cameraFor(scene, false);
    const Maps alone = renderer().render(scene, camera, shaded("none", {Map::Shade}));
    const Maps under = renderer().render(scene, camera, shaded("gooch", {Map::Shade}));
    EXPECT_EQ(alone.shade, under.shade);
    EXPECT_EQ(alone.picture, renderer().render(scene, camera, shaded("none")).picture) << "the picture stays as it was";
    EXPECT_TRUE(renderer().render(scene, camera, shaded("gooch")).shade.empty()) << "not asked for";
}

TEST_P(Shades, goWithEveryStyleDetectorAndBackground) {
    const Scene scene = colorfulScene();
    const Camera camera = cameraFor(scene, false);
    for (const char* const style : {"ink", "hatch", "sumi", "pencil", "none"}) {
        for (const char* const detector : {"planes", "classic", "saito-takahashi", "none"}) {
            for (const char* const background : {"#204060", "none"}) {
                SCOPED_TRACE(testing::Message() << style << ", " << detector << ", " << background);
                Settings settings = shaded("base-color", {Map::Shade});
                set(settings, "style", style, "test");
                set(settings, "detector", detector, "test");
                set(settings, "background", background, "test");
                const Maps maps = renderer().render(scene, camera, settings);
                const bool clear = !settings.picture.background.has_value();
                ASSERT_EQ(maps.picture.channels(), clear ? 4 : 3);
                // The picture's corner has no surface, its middle has one; black ink makes it darker, if it lies there.
                EXPECT_EQ(maps.picture.at(0, 0, clear ? 3 : 1), clear ? 0 : 0x40);
                int same = 0;
                int lighter = 0;
                for (int y = 20; y < 50; ++y) {
                    for (int x = 30; x < 60; ++x) {
                        same += maps.picture.at(x, y, 0) == maps.shade.at(x, y, 0) ? 1 : 0;
                        if (maps.shade.at(x, y, 3) != 255) continue;  // the background shows
                        lighter += maps.picture.at(x, y, 0) > maps.shade.at(x, y, 0) + 2 ? 1 : 0;
                    }
                }
                EXPECT_GT(same, style == std::string_view{"sumi"} ? -1 : 200) << "the brush leaves some ink everywhere";
                EXPECT_EQ(lighter, 0);
            }
        }
    }
}

TEST_P(Shades, inTilesAreTheSame) {
    const Scene scene = colorfulScene();
    constexpr Size large{600, 400};
    Settings settings = shaded("light", {Map::Shade});
    settings.picture.size = large;
    settings.picture.supersampling = 2;
    const Camera camera = frameCamera(scene, {}, large);
    const Maps whole = renderer().render(scene, camera, settings);
    settings.picture.tileSize = 256;
    const Maps tiled = renderer().render(scene, camera, settings);
    int differing = 0;
    for (std::size_t i = 0; i < whole.shade.pixels().size(); ++i)
        differing += std::abs(whole.shade.pixels()[i] - tiled.shade.pixels()[i]) > 1 ? 1 : 0;
    EXPECT_LE(differing, 20) << "samples within rounding of an edge, where interpolation starts elsewhere";
    const auto partly = std::ranges::count_if(whole.shade.pixels(), [](auto v) { return v > 60 && v < 70; });
    EXPECT_GT(partly, 0) << "pixels of which one sample of four is covered";
}

TEST_P(Shades, ofLinesAreThoseOfThePicture) {
    const Scene scene = colorfulScene();
    const Camera camera = cameraFor(scene, false);
    Settings settings = shaded("gooch", {Map::Shade});
    settings.lines.from = LinesFrom::Image;
    EXPECT_EQ(renderer().lines(scene, camera, settings).shade, renderer().render(scene, camera, settings).shade);
    settings.shade.shade = Shade::None;
    EXPECT_TRUE(renderer().lines(scene, camera, settings).shade.empty());
}

}  // namespace
}  // namespace inkedge::passes

// Styles: the effects of Hertzmann 1999, Figure 2, and its reference 5.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include <inkedge/setting_table.h>
#include "reference/reference.h"

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/frame.h"
#include "passes/hatch.h"
#include "passes/pencil.h"
#include "passes/sumi.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using gl_test::toDouble;

INKEDGE_ON_EACH_BACKEND(Styles);

constexpr Size size{160, 120};

Scene ballAndBox() {
    Mesh box = scenes::box({2, 1, 1.5});
    return scenes::sceneOf({{scenes::sphere(1.0, 24), scenes::translation({-0.8, 0.3, 0.5})},
                            {std::move(box), scenes::rotation(30, {1, 2, 0})}});
}

Camera cameraFor(const Scene& scene, bool orthographic = false) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 25.0;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return frameCamera(scene, cameraSettings, size);
}

// Pixels that differ by more than this.
int farFrom(const Image<std::uint8_t>& found, const Image<double>& expected, double tolerance) {
    EXPECT_EQ(found.pixels().size(), expected.pixels().size());
    int far = 0;
    for (std::size_t i = 0; i < found.pixels().size(); ++i)
        far += std::abs(found.pixels()[i] - 255.0 * expected.pixels()[i]) > tolerance ? 1 : 0;
    return far;
}

double sumOf(const Image<std::uint8_t>& ink) {
    return std::accumulate(ink.pixels().begin(), ink.pixels().end(), 0.0) / 255.0;
}

StyleSettings hatchWith(double bend, double shade, double width) {
    StyleSettings settings;
    settings.style = Style::Hatch;
    settings.hatchBend = bend;
    settings.hatchShade = shade;
    settings.hatchWidth = width;
    return settings;
}

struct Hatched {
    Image<float> planes;
    Image<std::uint8_t> ink;
    double focalLength;
};

Hatched hatched(gl::Gpu& gpu, const Scene& scene, const Camera& camera, const StyleSettings& settings) {
    const gl::UploadedScene upload{gpu.api, scene};
    const Frame frame = frameOf(gpu, upload, scene, camera, size);
    const PlaneBuffers buffers = drawPlanes(frame);
    return {gl::readFloats(gpu.api, buffers.planes, 4),
            hatch(frame, buffers.planes, settings, settings.hatchBend.value(), 1),
            camera.focalLength(size) * (camera.orthographic() ? frame.unit : 1.0)};
}

TEST_P(Styles, hatchMarksEqualTheirDefinition) {
    const gl::Current current{context()};
    const Scene scene = ballAndBox();
    for (const bool orthographic : {false, true}) {
        for (const StyleSettings& settings : {hatchWith(10, 1, 0.75), hatchWith(4, 0.3, 2), hatchWith(30, 0, 1)}) {
            const Camera camera = cameraFor(scene, orthographic);
            const Hatched found = hatched(gpu(), scene, camera, settings);
            const Image<double> expected =
                reference::hatch(found.planes, found.focalLength, orthographic, *settings.hatchBend,
                                 settings.hatchShade, settings.hatchWidth);
            EXPECT_GT(sumOf(found.ink), 50.0);
            // Slopes of a plane are floats: where a mark lies by their difference some 1/1000 of a pixel; 2 of 255
            // with rounding. Whether facets go on is decided at angles within rounding of each other now and then.
            EXPECT_LE(farFrom(found.ink, expected, 2.0), 8);
        }
    }
}

// Two upright quads that meet in x = 0 and bend there by an angle.
Scene fold(double bend) {
    const double z = -2.0 * std::tan(0.5 * glm::radians(bend));
    Mesh mesh;
    mesh.name = "fold";
    for (const glm::dvec3& p : {glm::dvec3{-2, -2, z}, {0, -2, 0}, {0, 2, 0}, {-2, 2, z}, {2, -2, z}, {2, 2, z}})
        mesh.positions.emplace_back(p);
    mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    return scenes::sceneOf(mesh);
}

Camera frontOf(const Scene& scene, double azimuth = 0.0) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = azimuth;
    cameraSettings.elevationAngle = 0.0;
    return frameCamera(scene, cameraSettings, size);
}

TEST_P(Styles, aHatchMarkIsAsWideAsItIsSetAndLiesWhereFacetsMeet) {
    const gl::Current current{context()};
    const Scene scene = fold(20.0);
    for (const double azimuth : {0.0, 7.0, -12.0}) {
        const Camera camera = frontOf(scene, azimuth);
        const glm::dvec4 seam = camera.projection(size) * camera.view * glm::dvec4{0.0, 0.0, 0.0, 1.0};
        const double expected = (0.5 + 0.5 * seam.x / seam.w) * size.width;
        for (const double width : {0.25, 0.75, 1.0, 1.5, 2.0}) {
            const Image<std::uint8_t> ink = hatched(gpu(), scene, camera, hatchWith(5, 0, width)).ink;
            for (int y = 30; y < 90; y += 7) {
                double covered = 0.0;
                double middle = 0.0;
                for (int x = 0; x < size.width; ++x) {
                    covered += ink.at(x, y) / 255.0;
                    middle += ink.at(x, y) / 255.0 * (x + 0.5);
                }
                // By the distance of a pixel's centre the sum over a row is right to the area above and below width 1.
                EXPECT_NEAR(covered, width, width < 1.0 ? 0.26 : 0.03) << azimuth << ", " << y;
                // A mark that lies within one pixel has that pixel's centre.
                EXPECT_NEAR(middle / covered, expected, std::max(0.5 - 0.5 * width, 0.13)) << azimuth << ", " << y;
            }
        }
    }
}

TEST_P(Styles, facetsHaveHatchMarksByHowMuchTheyBend) {
    const gl::Current current{context()};
    const auto markOf = [&](double bend) {
        const Scene scene = fold(bend);
        return sumOf(hatched(gpu(), scene, frontOf(scene), hatchWith(10, 0, 1)).ink);
    };
    EXPECT_EQ(markOf(6.5), 0.0);
    EXPECT_NEAR(markOf(10.0), 0.5 * markOf(14.0), 0.05 * markOf(14.0));
    EXPECT_GT(markOf(14.0), 50.0);
}

TEST_P(Styles, hatchMarksAreFewerInTheLight) {
    const gl::Current current{context()};
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 32));
    const auto inkOf = [&](double shade) {
        const Image<std::uint8_t> ink = hatched(gpu(), scene, frontOf(scene), hatchWith(8, shade, 1)).ink;
        double lit = 0.0;
        double dark = 0.0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) (x + y < (size.width + size.height) / 2 ? lit : dark) += ink.at(x, y);
        return lit / dark;
    };
    EXPECT_LT(inkOf(1.0), 0.3);
    EXPECT_NEAR(inkOf(0.0), 1.0, 0.05);
}

// Two sheets, one in front of the other: nothing bends, and where one ends is no fold.
TEST_P(Styles, surfacesInFrontOfEachOtherHaveNoHatchMarks) {
    const gl::Current current{context()};
    Mesh front = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    Mesh back = scenes::quad({-2, -2, -1}, {2, -2, -1}, {2, 2, -2}, {-2, 2, -2});
    const Scene scene = scenes::sceneOf({{std::move(front), glm::dmat4{1.0}}, {std::move(back), glm::dmat4{1.0}}});
    EXPECT_EQ(sumOf(hatched(gpu(), scene, frontOf(scene), hatchWith(1, 0, 2)).ink), 0.0);
}

StyleSettings sumiWith(double width, double length, int streaks = 0) {
    StyleSettings settings;
    settings.style = Style::Sumi;
    settings.sumiWidth = width;
    settings.sumiLength = length;
    settings.sumiStreaks = streaks;
    return settings;
}

TEST_P(Styles, aBrushEqualsItsDefinition) {
    const gl::Current current{context()};
    const Scene scene = ballAndBox();
    for (const bool orthographic : {false, true}) {
        const Camera camera = cameraFor(scene, orthographic);
        const gl::UploadedScene upload{gpu().api, scene};
        const Frame frame = frameOf(gpu(), upload, scene, camera, size);
        const SurfaceBuffers buffers = drawSurface(frame, {});
        const Image<float> read = gl::readFloats(gpu().api, buffers.surface, 4);
        Image<double> depth{size, 1};
        Image<double> normal{size, 3};
        for (std::size_t i = 0; i < depth.pixels().size(); ++i) {
            depth.mutablePixels()[i] = static_cast<double>(read.pixels()[4 * i + 3]);
            for (std::size_t c = 0; c < 3; ++c)
                normal.mutablePixels()[3 * i + c] = static_cast<double>(read.pixels()[4 * i + c]);
        }
        for (const StyleSettings& settings : {sumiWith(6, 24), sumiWith(1, 0), sumiWith(12, 5, 40)}) {
            const Image<std::uint8_t> ink = sumi(frame, buffers.surface, settings);
            EXPECT_GT(sumOf(ink), 200.0);
            // Paths of tangents turn off where one passes between two pixels, within float rounding; a sample's depth
            // may be within rounding of a step.
            EXPECT_LE(farFrom(ink, reference::sumi(depth, normal, camera, settings), 1.6), 60)
                << settings.sumiWidth << (orthographic ? ", orthographic" : ", perspective");
        }
    }
}

Image<std::uint8_t> pictureOf(Renderer& renderer, const Scene& scene, const Camera& camera, Settings settings) {
    settings.picture.size = size;
    return renderer.render(scene, camera, settings).picture;
}

// How dark a pixel of one channel is, 0 to 1.
double inkAt(const Image<std::uint8_t>& picture, int x, int y) { return 1.0 - picture.at(x, y) / 255.0; }

TEST_P(Styles, aBrushIsAsWideAsItIsSet) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frontOf(scene);
    for (const double width : {4.0, 8.0, 16.0}) {
        Settings settings;
        settings.style = sumiWith(width, 8);
        const Image<std::uint8_t> picture = pictureOf(renderer(), scene, camera, settings);
        double ink = 0.0;
        double darkest = 0.0;
        for (int x = 0; x < size.width / 2; ++x) {
            ink += inkAt(picture, x, size.height / 2);
            darkest = std::max(darkest, inkAt(picture, x, size.height / 2));
        }
        EXPECT_GT(darkest, 0.9);
        // A soft line is half as dark over about its width.
        EXPECT_NEAR(ink / darkest, width, 0.3 * width);
    }
}

TEST_P(Styles, samplingDepthLeavesStreaks) {
    // A floor that runs away from the eye: streaks are level.
    const Scene scene = scenes::sceneOf(scenes::quad({-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}));
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 0.0;
    cameraSettings.elevationAngle = 45.0;
    cameraSettings.orthographicHeight = 3.0;
    const Camera camera = frameCamera(scene, cameraSettings, size);
    const auto streaksDown = [&](int steps) {
        Settings settings;
        settings.style = sumiWith(2, 8, steps);
        const Image<std::uint8_t> picture = pictureOf(renderer(), scene, camera, settings);
        int streaks = 0;
        for (int y = 1; y + 1 < size.height; ++y) {
            const double ink = inkAt(picture, size.width / 2, y);
            const bool peak =
                ink > inkAt(picture, size.width / 2, y - 1) && ink >= inkAt(picture, size.width / 2, y + 1);
            streaks += peak && ink > 0.2 ? 1 : 0;
        }
        return streaks;
    };
    // What is shown, three units high, is three units deep at 45 degrees.
    const double share = 3.0 / (camera.far - camera.near);
    EXPECT_NEAR(streaksDown(16), 16.0 * share, 1.0);
    EXPECT_NEAR(streaksDown(24), 24.0 * share, 1.0);
    EXPECT_EQ(streaksDown(0), 0);
}

StyleSettings pencilWith(int strokes, double looseness, int seed) {
    StyleSettings settings;
    settings.style = Style::Pencil;
    settings.pencilStrokes = strokes;
    settings.pencilLooseness = looseness;
    settings.pencilSeed = seed;
    return settings;
}

TEST_P(Styles, pencilEqualsItsDefinition) {
    const Scene scene = ballAndBox();
    Settings plain;
    plain.picture.size = size;
    plain.picture.background.reset();
    set(plain, "line-style", "crease:color=#c02010,width=3", "");
    const Image<std::uint8_t> drawing = renderer().render(scene, cameraFor(scene), plain).picture;
    ASSERT_EQ(drawing.channels(), 4);
    const gl::Current current{context()};
    for (const StyleSettings& settings : {pencilWith(3, 3, 1), pencilWith(1, 0, 9), pencilWith(8, 20, 65535)}) {
        const Image<std::uint8_t> found = pencil(gpu(), drawing, settings, 4096);
        Image<double> expected = reference::pencil(drawing, settings);
        Image<std::uint8_t> visible = found;
        // A colour of which there is almost nothing is mostly rounding.
        for (std::size_t i = 0; i < found.pixels().size(); i += 4) {
            if (found.pixels()[i + 3] >= 8) continue;
            for (std::size_t c = 0; c < 3; ++c)
                visible.mutablePixels()[i + c] = 0, expected.mutablePixels()[i + c] = 0.0;
        }
        EXPECT_GT(sumOf(found), 100.0);
        EXPECT_LE(farFrom(visible, expected, 1.6), 4);
    }
}

double meanDifference(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b) {
    EXPECT_EQ(a.pixels().size(), b.pixels().size());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) sum += std::abs(a.pixels()[i] - b.pixels()[i]);
    return sum / static_cast<double>(a.pixels().size());
}

TEST_P(Styles, pencilStrokesStrayTheSameWayWhileTheCameraMoves) {
    const Scene scene = ballAndBox();
    Settings ink;
    Settings drawn;
    drawn.style = pencilWith(3, 3, 1);
    const auto cameraAt = [&](double azimuth) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = azimuth;
        return frameCamera(scene, cameraSettings, size);
    };
    const auto moved = [&](const Settings& settings) {
        return meanDifference(pictureOf(renderer(), scene, cameraAt(25.0), settings),
                              pictureOf(renderer(), scene, cameraAt(25.2), settings));
    };
    const Image<std::uint8_t> first = pictureOf(renderer(), scene, cameraAt(25.0), drawn);
    EXPECT_EQ(first.pixels(), pictureOf(renderer(), scene, cameraAt(25.0), drawn).pixels());
    // Three strokes move as much as three lines.
    EXPECT_LT(moved(drawn), 3.0 * moved(ink));
    drawn.style.pencilSeed = 2;
    EXPECT_GT(meanDifference(first, pictureOf(renderer(), scene, cameraAt(25.0), drawn)), 5.0 * moved(ink));
}

TEST_P(Styles, strokesStrayAsFarAsTheyAreLoose) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frontOf(scene);
    for (const double looseness : {0.0, 2.0, 6.0}) {
        Settings settings;
        settings.lines.from = LinesFrom::Image;
        const Image<std::uint8_t> ink = pictureOf(renderer(), scene, camera, settings);
        settings.style = pencilWith(8, looseness, 5);
        const Image<std::uint8_t> drawn = pictureOf(renderer(), scene, camera, settings);
        int line = 0;
        while (inkAt(ink, line, size.height / 2) == 0.0) ++line;
        double furthest = 0.0;
        for (int y = size.height / 3; y < 2 * size.height / 3; ++y)
            for (int x = 0; x < size.width / 2; ++x)
                if (inkAt(drawn, x, y) > 0.1) furthest = std::max(furthest, std::abs(x - line) * 1.0);
        EXPECT_GE(furthest, 0.5 * looseness);
        EXPECT_LE(furthest, 2.0 * looseness + 3.0) << "with the line's own width";
    }
}

TEST_P(Styles, haveTheChannelsOfTheirColors) {
    const Scene scene = ballAndBox();
    const Camera camera = cameraFor(scene);
    for (const Style style : {Style::Ink, Style::Hatch, Style::Sumi, Style::Pencil}) {
        Settings settings;
        settings.style.style = style;
        EXPECT_EQ(pictureOf(renderer(), scene, camera, settings).channels(), 1);
        settings.picture.background = Color{20, 40, 90};
        settings.picture.lineColor = {255, 255, 255};
        const Image<std::uint8_t> blue = pictureOf(renderer(), scene, camera, settings);
        ASSERT_EQ(blue.channels(), 3);
        EXPECT_EQ(blue.at(0, 0, 0), 20);
        EXPECT_EQ(blue.at(0, 0, 2), 90);
        EXPECT_GT(*std::ranges::max_element(blue.pixels()), 180) << "white lines";
        settings.picture.background.reset();
        const Image<std::uint8_t> none = pictureOf(renderer(), scene, camera, settings);
        ASSERT_EQ(none.channels(), 4);
        EXPECT_EQ(none.at(0, 0, 3), 0);
    }
}

TEST_P(Styles, areDrawnInTilesAsInOnePiece) {
    const Scene scene = ballAndBox();
    Settings settings;
    settings.picture.size = {900, 700};
    const Camera camera = frameCamera(scene, {}, settings.picture.size);
    for (const StyleSettings& style :
         {hatchWith(6, 1, 2), sumiWith(6, 24), sumiWith(32, 100), pencilWith(3, 32, 1), pencilWith(2, 3, 1)}) {
        settings.style = style;
        settings.picture.tileSize = 4096;
        const Image<std::uint8_t> whole = renderer().render(scene, camera, settings).picture;
        settings.picture.tileSize = 256;
        const Image<std::uint8_t> tiled = renderer().render(scene, camera, settings).picture;
        int differing = 0;
        for (std::size_t i = 0; i < whole.pixels().size(); ++i)
            differing += std::abs(whole.pixels()[i] - tiled.pixels()[i]) > 1 ? 1 : 0;
        // Planes count from the tile's corner: marks and decisions within rounding.
        EXPECT_LE(differing, 20) << static_cast<int>(style.style);
    }
}

TEST_P(Styles, hatchMarksOfManySamplesAreFinerButNotDarker) {
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 24));
    Settings settings;
    settings.style = hatchWith(5, 0, 1);
    settings.detector.detector = Detector::None;
    const Camera camera = frontOf(scene);
    const auto inkOf = [&](int samples) {
        settings.picture.supersampling = samples;
        const Image<std::uint8_t> picture = pictureOf(renderer(), scene, camera, settings);
        double ink = 0.0;
        for (const std::uint8_t value : picture.pixels()) ink += 1.0 - value / 255.0;
        return ink;
    };
    EXPECT_NEAR(inkOf(2), inkOf(1), 0.1 * inkOf(1));
    EXPECT_NEAR(inkOf(4), inkOf(1), 0.1 * inkOf(1));
}

}  // namespace
}  // namespace inkedge::passes

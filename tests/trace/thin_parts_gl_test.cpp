// Parts thinner than a pixel: whole, and as dark as they are thick, up to half a pixel; then on to two lines.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <glm/common.hpp>

#include "gl/gl_test.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "scenes.h"

namespace inkedge::trace {
namespace {

INKEDGE_ON_EACH_BACKEND(ThinParts);

constexpr Size square{200, 200};
constexpr double pixel = 0.02;  // in the world: the camera shows 4 units
constexpr double half = 1.2;    // a bar's length

Camera camera() {
    Camera camera;
    camera.view = scenes::translation({0, 0, -10});
    camera.orthographicHeight = pixel * square.height;
    camera.near = 5.0;
    camera.far = 15.0;
    return camera;
}

// An open tube of eight sides along the x axis.
Mesh tube(double thickness) {
    constexpr std::uint32_t sides = 8;
    Mesh mesh;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.3) / sides;
        for (const double x : {-half, half})
            mesh.positions.emplace_back(x, 0.5 * thickness * std::cos(angle), 0.5 * thickness * std::sin(angle));
        const std::uint32_t a = 2 * i;
        const std::uint32_t b = 2 * ((i + 1) % sides);
        mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
    return mesh;
}

struct Bar {
    const char* name;
    Mesh mesh;
    double thickness;  // pixels, as it is seen
};

std::vector<Bar> bars(double thickness) {
    const double t = thickness * pixel;
    // The silhouette of eight sides, of which the first is turned by 0.3 of a side.
    const double seen = std::cos(2.0 * std::numbers::pi * 0.3 / 8.0);
    return {{"box", scenes::box({2.0 * half, t, t}), thickness},
            {"plate seen from its edge", scenes::box({2.0 * half, t, 0.5}), thickness},
            {"sheet", scenes::quad({-half, -0.5 * t, 0}, {half, -0.5 * t, 0}, {half, 0.5 * t, 0}, {-half, 0.5 * t, 0}),
             thickness},
            {"tube", tube(t), thickness * seen}};
}

// Ink along the middle of a bar through the picture's middle.
struct Ink {
    double mean;  // pixels of full ink a pixel of length
    double min;   // of windows three pixels long
    double max;
};

Ink inkAlong(const Image<std::uint8_t>& picture, double degrees) {
    constexpr int window = 3;
    constexpr int windows = 26;
    std::vector<double> ink(windows, 0.0);
    const double angle = glm::radians(degrees);
    for (int y = 0; y < picture.size().height; ++y) {
        for (int x = 0; x < picture.size().width; ++x) {
            const glm::dvec2 p{x + 0.5 - 0.5 * picture.size().width, y + 0.5 - 0.5 * picture.size().height};
            const double along = std::cos(angle) * p.x - std::sin(angle) * p.y;
            const double across = std::sin(angle) * p.x + std::cos(angle) * p.y;
            const int at = static_cast<int>(std::floor(along / window)) + windows / 2;
            if (at < 0 || at >= windows || std::abs(across) > 6.0) continue;
            ink[static_cast<std::size_t>(at)] += (255 - picture(x, y)) / (255.0 * window);
        }
    }
    const auto [min, max] = std::ranges::minmax(ink);
    double sum = 0.0;
    for (const double i : ink) sum += i;
    return {sum / windows, min, max};
}

glm::dmat4 turned(double degrees) {
    // Between pixels, so that no sample lies on an edge.
    return scenes::translation({0.0013, 0.0027, 0.0}) * scenes::rotation(degrees, {0, 0, 1});
}

Settings drawn(int supersampling) {
    Settings settings;
    settings.picture.size = square;
    settings.picture.lineWidth = {1.0, false};
    settings.picture.supersampling = supersampling;
    return settings;
}

TEST_P(ThinParts, areWholeAndAsDarkAsTheyAreThick) {
    const Mesh wall = scenes::quad({-1.9, -1.9, -2}, {1.9, -1.9, -2}, {1.9, 1.9, -2}, {-1.9, 1.9, -2});
    for (const double thickness : {0.1, 0.3, 0.5}) {
        for (const Bar& bar : bars(thickness)) {
            for (const double degrees : {0.0, 17.0, 45.0, 71.0, 90.0}) {
                for (const bool beforeWall : {false, true}) {
                    for (const int supersampling : {1, 2}) {
                        SCOPED_TRACE(testing::Message() << bar.name << ' ' << thickness << ", " << degrees
                                                        << (beforeWall ? ", before a wall, " : ", ") << supersampling);
                        std::vector<std::pair<Mesh, glm::dmat4>> parts{{bar.mesh, turned(degrees)}};
                        if (beforeWall) parts.emplace_back(wall, glm::dmat4{1.0});
                        const Maps maps = renderer().render(scenes::sceneOf(parts), camera(), drawn(supersampling));
                        const Ink ink = inkAlong(maps.picture, degrees);
                        // Coverage is rounded to steps of 1/255, widths to steps of 1/128.
                        EXPECT_NEAR(ink.mean, bar.thickness, 0.02 + 0.04 * bar.thickness);
                        EXPECT_GT(ink.min, 0.6 * ink.mean);
                        EXPECT_LT(ink.max, 1.5 * ink.mean);
                    }
                }
            }
        }
    }
}

// Up to half a pixel as thick as the part; from there evenly to two lines of the pen's width, a pixel apart.
TEST_P(ThinParts, growSteadilyIntoTwoLines) {
    constexpr double step = 0.05;
    for (const std::size_t kind : {0U, 1U, 2U}) {
        double before = 0.0;
        for (double thickness = step; thickness < 3.0; thickness += step) {
            const Bar bar = bars(thickness)[kind];
            SCOPED_TRACE(testing::Message() << bar.name << ' ' << thickness);
            const Maps maps = renderer().render(scenes::sceneOf(bar.mesh, turned(17.0)), camera(), drawn(1));
            const double ink = inkAlong(maps.picture, 17.0).mean;
            // 3 a pixel of thickness at most: two lines that overlap cover 3 t - 1.
            EXPECT_LT(ink - before, 3.5 * step);
            EXPECT_GT(ink - before, -0.5 * step);
            before = ink;
        }
        EXPECT_NEAR(before, 2.0, 0.1);
    }
}

TEST_P(ThinParts, areDrawnOnWhatTheyLieOn) {
    const Mesh wall = scenes::box({3.4, 3.4, 0.5});
    for (const double thickness : {0.1, 0.3, 0.5}) {
        for (const std::size_t kind : {0U, 2U, 3U}) {  // a plate would run through the wall
            const Bar bar = bars(thickness)[kind];
            for (const double height : {0.5, -0.6}) {  // of its middle over the wall, in thicknesses
                SCOPED_TRACE(testing::Message() << bar.name << ' ' << thickness << " at " << height);
                const glm::dmat4 lift = scenes::translation({0, 0, height * thickness * pixel});
                const glm::dmat4 behind = scenes::translation({0, 0, -0.25});
                const Image<std::uint8_t> picture =
                    renderer()
                        .render(scenes::sceneOf({{bar.mesh, lift * turned(17.0)}, {wall, behind}}), camera(), drawn(1))
                        .picture;
                const Ink ink = inkAlong(picture, 17.0);
                if (height < 0.0) {
                    EXPECT_EQ(ink.max, 0.0) << "hidden";
                    continue;
                }
                EXPECT_NEAR(ink.mean, bar.thickness, 0.02 + 0.04 * bar.thickness);
                EXPECT_GT(ink.min, 0.6 * ink.mean);
                EXPECT_LT(ink.max, 1.5 * ink.mean);
            }
        }
    }
}

// What vector files and pictures of them draw.
TEST_P(ThinParts, haveTheSameInkAsLines) {
    Settings settings = drawn(1);
    settings.lines.from = LinesFrom::Image;
    for (const double thickness : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        for (const Bar& bar : bars(thickness)) {
            SCOPED_TRACE(testing::Message() << bar.name << ' ' << thickness);
            const Scene scene = scenes::sceneOf(bar.mesh, turned(17.0));
            const Lines lines = renderer().lines(scene, camera(), settings);
            const Image<std::uint8_t> ofLines =
                ink::paintStrokes(ink::strokesOf(lines, settings.picture, settings.lines), settings.picture, nullptr,
                                  settings::Paper::Background);
            const Ink ink = inkAlong(renderer().render(scene, camera(), drawn(1)).picture, 17.0);
            EXPECT_NEAR(inkAlong(ofLines, 17.0).mean, ink.mean, 0.02);
        }
    }
}

TEST_P(ThinParts, areOneLineEach) {
    Settings settings = drawn(1);
    settings.lines.from = LinesFrom::Image;
    for (const double thickness : {0.05, 0.3, 0.49}) {
        for (const Bar& bar : bars(thickness)) {
            for (const double degrees : {0.0, 17.0, 71.0}) {
                SCOPED_TRACE(testing::Message() << bar.name << ' ' << thickness << ", " << degrees);
                const Scene scene = scenes::sceneOf(bar.mesh, turned(degrees));
                const Lines lines = renderer().lines(scene, camera(), settings);
                ASSERT_EQ(lines.lines.size(), 1U);
                const Line& line = lines.lines[0];
                EXPECT_EQ(line.type, LineType::Outline);
                EXPECT_NEAR(line.width, bar.thickness, 0.01);
                EXPECT_NEAR(glm::distance(line.points.front().pixel, line.points.back().pixel), 2.0 * half / pixel,
                            1.0);
            }
        }
    }
}

TEST_P(ThinParts, areHiddenByWhatLiesBeforeThem) {
    const Mesh screen = scenes::quad({-0.5, -0.8, 1}, {0.5, -0.8, 1}, {0.5, 0.8, 1}, {-0.5, 0.8, 1});
    const Scene scene = scenes::sceneOf({{bars(0.5)[0].mesh, turned(10.0)}, {screen, glm::dmat4{1.0}}});
    const Image<std::uint8_t> picture = renderer().render(scene, camera(), drawn(1)).picture;
    for (int y = 70; y < 130; ++y)
        for (int x = 78; x < 122; ++x) ASSERT_EQ(picture(x, y), 255) << x << ", " << y;
    double beside = 0.0;
    for (int y = 60; y < 140; ++y)
        for (int x = 50; x < 70; ++x) beside += (255 - picture(x, y)) / 255.0;
    EXPECT_NEAR(beside, 0.5 * 20 / std::cos(glm::radians(10.0)), 1.0);
}

TEST_P(ThinParts, leaveTheLinesBehindThemWhole) {
    // The edge of a sheet runs across behind a wire.
    const Mesh sheet = scenes::quad({-0.4, -1.5, -1}, {0.4, -1.5, -1}, {0.4, 1.5, -1}, {-0.4, 1.5, -1});
    const Scene scene = scenes::sceneOf({{bars(0.3)[0].mesh, turned(23.0)}, {sheet, glm::dmat4{1.0}}});
    const Image<std::uint8_t> picture = renderer().render(scene, camera(), drawn(1)).picture;
    for (int y = 60; y < 140; ++y) {
        double ink = 0.0;
        for (int x = 76; x < 84; ++x) ink += (255 - picture(x, y)) / 255.0;
        EXPECT_GT(ink, 0.9) << y;
    }
}

// A square sheet with a slit along the x axis.
Mesh slitSheet(double gap) {
    Mesh mesh;
    for (const auto& [x, y] : {std::pair{1.5, 1.5}, std::pair{half, 0.5 * gap * pixel}})
        for (const glm::dvec2 corner : {glm::dvec2{-x, -y}, {x, -y}, {x, y}, {-x, y}})
            mesh.positions.emplace_back(corner.x, corner.y, 0.0);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        mesh.indices.insert(mesh.indices.end(), {i, next, next + 4, i, next + 4, i + 4});
    }
    return mesh;
}

const Mesh behind = scenes::quad({-1.9, -1.9, -2}, {1.9, -1.9, -2}, {1.9, 1.9, -2}, {-1.9, 1.9, -2});

TEST_P(ThinParts, thatAreGapsAreWhole) {
    for (const double gap : {0.15, 0.4, 0.7, 0.95, 1.2}) {
        for (const double degrees : {0.0, 17.0, 45.0, 71.0, 90.0}) {
            for (const bool beforeWall : {false, true}) {
                for (const int supersampling : {1, 2}) {
                    SCOPED_TRACE(testing::Message() << gap << ", " << degrees
                                                    << (beforeWall ? ", before a wall, " : ", ") << supersampling);
                    std::vector<std::pair<Mesh, glm::dmat4>> parts{{slitSheet(gap), turned(degrees)}};
                    if (beforeWall) parts.emplace_back(behind, glm::dmat4{1.0});
                    const Maps maps = renderer().render(scenes::sceneOf(parts), camera(), drawn(supersampling));
                    const Ink ink = inkAlong(maps.picture, degrees);
                    // Of one line that parts in two from half a pixel on; windows across the grid hold more pixels or
                    // fewer.
                    const double apart = std::clamp(2.0 * gap - 1.0, 0.0, 1.0) * gap;
                    EXPECT_GT(ink.min, 0.7);
                    EXPECT_NEAR(ink.mean, 1.0 + std::min(apart, 1.0), 0.25);  // a pixel that both cover is inked once
                    EXPECT_LT(ink.max, 1.5 * ink.mean);
                }
            }
        }
    }
}

TEST_P(ThinParts, thatAreGapsHaveTheTypesThatTheMeshGivesThem) {
    for (const bool beforeWall : {false, true}) {
        std::vector<std::pair<Mesh, glm::dmat4>> parts{{slitSheet(0.4), turned(17.0)}};
        if (beforeWall) parts.emplace_back(behind, glm::dmat4{1.0});
        const Scene scene = scenes::sceneOf(parts);
        std::vector<std::set<LineType>> found;
        for (const LinesFrom from : {LinesFrom::Image, LinesFrom::Object}) {
            Settings settings = drawn(1);
            settings.lines.from = from;
            std::set<LineType>& types = found.emplace_back();
            for (const Line& line : renderer().lines(scene, camera(), settings).lines) {
                const auto isAtSlit = [](const LinePoint& p) { return glm::distance(p.pixel, {100.0, 100.0}) < 62.0; };
                if (line.visible && std::ranges::all_of(line.points, isAtSlit)) types.insert(line.type);
            }
            EXPECT_EQ(types.size(), 1U);
        }
        EXPECT_EQ(found[0], found[1]) << beforeWall;
    }
}

TEST_P(ThinParts, areNoCracks) {
    for (const double degrees : {0.0, 17.0, 45.0}) {
        const Scene scene = scenes::sceneOf({{slitSheet(0.06), turned(degrees)}, {behind, glm::dmat4{1.0}}});
        EXPECT_LT(inkAlong(renderer().render(scene, camera(), drawn(1)).picture, degrees).mean, 0.05) << degrees;
    }
}

TEST_P(ThinParts, thatAreGapsAreHiddenByWhatLiesBeforeThem) {
    const Mesh screen = scenes::quad({-0.5, -0.8, 1}, {0.5, -0.8, 1}, {0.5, 0.8, 1}, {-0.5, 0.8, 1});
    const Scene scene = scenes::sceneOf({{slitSheet(0.5), turned(10.0)}, {screen, glm::dmat4{1.0}}});
    const Image<std::uint8_t> picture = renderer().render(scene, camera(), drawn(1)).picture;
    for (int y = 70; y < 130; ++y)
        for (int x = 78; x < 122; ++x) ASSERT_EQ(picture(x, y), 255) << x << ", " << y;
}

}  // namespace
}  // namespace inkedge::trace

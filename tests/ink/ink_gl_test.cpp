// The ink of whole renders against exact strokes.
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "gl/gl_test.h"
#include "ink/ink_measures.h"
#include "scenes.h"

namespace inkedge::ink {
namespace {

using ink_measures::Line;

INKEDGE_ON_EACH_BACKEND(Ink);

constexpr std::array widths{1.0, 2.0, 3.5, 8.0};
constexpr int angleCount = 30;
// Over a quarter turn, for shapes of four sides, and over half a turn.
double quarterAngle(int i) { return i * 90.0 / angleCount + 0.7; }
double halfAngle(int i) { return i * 180.0 / angleCount + 0.7; }

constexpr Size square{112, 112};

// A camera on +Z, ten units off, that shows the square -1..1 of the plane z = 0.
Camera cameraOn(bool orthographic) {
    Camera camera;
    camera.view = scenes::translation({0, 0, -10});
    camera.near = 5.0;
    camera.far = 20.0;
    if (orthographic) camera.orthographicHeight = 2.0;
    camera.viewAngle = glm::degrees(2.0 * std::atan(0.1));
    return camera;
}

Settings ink(Size size, double width, std::vector<Map> maps = {}) {
    Settings settings;
    settings.picture.size = size;
    settings.picture.lineWidth = {width, false};
    settings.maps = std::move(maps);
    return settings;
}

Line lineBetween(const Camera& camera, Size size, glm::dvec3 a, glm::dvec3 b) {
    return {scenes::pixel(camera, size, a), scenes::pixel(camera, size, b)};
}

glm::dvec3 turned(glm::dvec3 p, double degrees) {
    return glm::dvec3{scenes::rotation(degrees, {0, 0, 1}) * glm::dvec4{p, 1}};
}

// What a line may lack where it is thinnest: a gap of one pixel in a line of width 1 would lack all of its ink.
constexpr double gapLimit = 0.5;
constexpr double tipLimit = 0.75;

TEST_P(Ink, ofASilhouetteIsExactAtEveryAngleAndWidth) {
    for (const bool orthographic : {true, false}) {
        const Camera camera = cameraOn(orthographic);
        std::array<ink_measures::Difference, widths.size()> corners;
        for (int i = 0; i < angleCount; ++i) {
            std::vector<glm::dvec3> ends;
            for (const glm::dvec2 c : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                ends.push_back(turned({0.6 * c.x + 0.0031 * i, 0.6 * c.y - 0.0017 * i, 0}, quarterAngle(i)));
            }
            const Scene scene = scenes::sceneOf(scenes::quad(ends[0], ends[1], ends[2], ends[3]));
            std::vector<Line> lines;
            for (std::size_t k = 0; k < 4; ++k)
                lines.push_back(lineBetween(camera, square, ends[k], ends[(k + 1) % 4]));
            for (std::size_t w = 0; w < widths.size(); ++w) {
                const double width = widths[w];
                SCOPED_TRACE(testing::Message() << (orthographic ? "orthographic" : "perspective") << ", angle "
                                                << quarterAngle(i) << ", width " << width);
                const Image<double> drawn =
                    ink_measures::inkOf(renderer().render(scene, camera, ink(square, width)).picture);
                const Image<double> exact = ink_measures::exactInk(square, lines, width);
                const double corner = 0.5 * width + 3.0;  // the cell of the corner and the ink about it
                for (const Line& line : lines) {
                    ink_measures::expectStraight(ink_measures::measure(drawn, line, width, corner), width);
                    ink_measures::compareAround(drawn, exact, line.a, corner, corners[w]);
                    EXPECT_LE(ink_measures::maxMissing(drawn, exact, line), gapLimit);
                }
            }
        }
        for (std::size_t w = 0; w < widths.size(); ++w) {
            EXPECT_LE(corners[w].rms(), ink_measures::cornerRmsLimit) << "corners at width " << widths[w];
        }
    }
}

TEST_P(Ink, ofACreaseIsExactAtEveryAngleAndWidth) {
    for (const bool orthographic : {true, false}) {
        const Camera camera = cameraOn(orthographic);
        for (int i = 0; i < angleCount; ++i) {
            // Two planes that bend by 70 degrees along a line in z = 0 and fill the picture, falling off unevenly.
            const auto at = [&](double x, double y, double z) { return turned({x + 0.0041 * i, y, z}, halfAngle(i)); };
            Mesh roof;
            for (const glm::dvec3& p :
                 {at(-3, -3, -3 * std::tan(glm::radians(50.0))), at(0, -3, 0), at(0, 3, 0),
                  at(-3, 3, -3 * std::tan(glm::radians(50.0))), at(3, -3, -3 * std::tan(glm::radians(20.0))),
                  at(3, 3, -3 * std::tan(glm::radians(20.0)))}) {
                roof.positions.emplace_back(p);
            }
            roof.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
            const Scene scene = scenes::sceneOf(roof);
            const Line ridge = lineBetween(camera, square, at(0, -0.75, 0), at(0, 0.75, 0));
            for (const double width : widths) {
                SCOPED_TRACE(testing::Message() << (orthographic ? "orthographic" : "perspective") << ", angle "
                                                << halfAngle(i) << ", width " << width);
                const Maps maps = renderer().render(scene, camera, ink(square, width, {Map::Types}));
                EXPECT_THAT(maps.types.pixels(), testing::Each(testing::AnyOf(0, static_cast<int>(LineType::Crease))));
                ink_measures::expectStraight(
                    ink_measures::measure(ink_measures::inkOf(maps.picture), ridge, width, 0.0), width);
            }
        }
    }
}

// Straight as they are, strokes of a bundle of points along an outline lie within this of it.
struct OutlinePoints {
    std::vector<glm::dvec2> pixels;
    std::vector<glm::dvec2> normals;
};

void expectCentred(const Image<double>& drawn, const OutlinePoints& outline, double width) {
    double sum = 0.0;
    double furthest = 0.0;
    for (std::size_t i = 0; i < outline.pixels.size(); ++i) {
        const double offset =
            std::abs(ink_measures::offsetAcross(drawn, outline.pixels[i], outline.normals[i], 0.5 * width + 2.5));
        sum += offset;
        furthest = std::max(furthest, offset);
    }
    EXPECT_LE(sum / static_cast<double>(outline.pixels.size()), ink_measures::centreLimit);
    EXPECT_LE(furthest, 1.0);  // nowhere beside its pixel; the average could hide a gap
}

TEST_P(Ink, ofASphereRunsAlongItsCircle) {
    // 512 segments: the polygon lies within 500 (1 - cos(pi / 512)) = 0.01 pixel of the circle.
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 512));
    for (const bool orthographic : {true, false}) {
        Camera camera;
        camera.view = scenes::translation({0.013, -0.021, -4}) * scenes::rotation(31, {1, 2, 3});
        camera.near = 2.0;
        camera.far = 6.0;
        if (orthographic) camera.orthographicHeight = 2.6;
        for (const int side : {64, 320}) {
            const Size size{side, side};
            // Tangents from the eye touch the sphere on a circle; in perspective its picture is an ellipse.
            OutlinePoints outline;
            const glm::dvec3 middle{0.013, -0.021, -4};
            const glm::dvec3 axis = orthographic ? glm::dvec3{0, 0, 1} : -glm::normalize(middle);
            const double distance = glm::length(middle);
            const double height = orthographic ? 0.0 : 1.0 / distance;  // of the circle's plane, towards the eye
            const glm::dvec3 u = glm::normalize(glm::cross(axis, glm::dvec3{0, 1, 0}));
            const glm::dvec3 v = glm::cross(axis, u);
            Camera inView = camera;
            inView.view = glm::dmat4{1.0};
            for (int i = 0; i < 360; ++i) {
                const auto at = [&](double degrees) {
                    const double t = glm::radians(degrees);
                    const double r = std::sqrt(1.0 - height * height);
                    return scenes::pixel(inView, size,
                                         middle + height * axis + r * (std::cos(t) * u + std::sin(t) * v));
                };
                const glm::dvec2 along = glm::normalize(at(i + 0.1) - at(i - 0.1));
                outline.pixels.push_back(at(i));
                outline.normals.emplace_back(-along.y, along.x);
            }
            for (const double width : {1.0, 3.5}) {
                SCOPED_TRACE(testing::Message() << side << " pixels, width " << width);
                const Maps maps = renderer().render(scene, camera, ink(size, width));
                expectCentred(ink_measures::inkOf(maps.picture), outline, width);
            }
        }
    }
}

// A ring about the y axis: the tube's circles lie in planes through the axis.
Mesh torus(double major, double minor, std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    mesh.name = "torus";
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            const double u = 2.0 * std::numbers::pi * i / around;
            const double t = 2.0 * std::numbers::pi * k / across;
            const double r = major + minor * std::cos(t);
            mesh.positions.emplace_back(glm::dvec3{r * std::sin(u), minor * std::sin(t), r * std::cos(u)});
            const std::uint32_t next = (i + 1) % around;
            const std::uint32_t up = (k + 1) % across;
            mesh.indices.insert(mesh.indices.end(), {i * across + k, next * across + k, next * across + up,
                                                     i * across + k, next * across + up, i * across + up});
        }
    }
    return mesh;
}

TEST_P(Ink, ofATorusRunsAlongItsContour) {
    constexpr double major = 1.0;
    constexpr double minor = 0.35;
    // 512 x 256: the polygons lie within 0.01 pixel of the surface.
    const Scene scene = scenes::sceneOf(torus(major, minor, 512, 256));
    constexpr Size size{320, 240};
    for (const double elevation : {90.0, 60.0, 40.0}) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 12.0;
        cameraSettings.elevationAngle = elevation;
        if (elevation == 90.0) cameraSettings.viewUp = glm::dvec3{0, 0, -1};
        cameraSettings.orthographicHeight = 2.9;
        const Camera camera = frameCamera(scene, cameraSettings, size);
        const glm::dvec3 eye = glm::transpose(glm::dmat3{camera.view}) * glm::dvec3{0, 0, 1};
        // Where the normal cos t e + sin t y stands across the view: tan t = - (e . eye) / (y . eye). One solution's
        // side of the tube faces outwards from the ring: these points are seen against the background.
        OutlinePoints outline;
        const auto at = [&](double degrees) {
            const double u = glm::radians(degrees);
            const glm::dvec3 e{std::sin(u), 0, std::cos(u)};
            const double t = std::atan2(-glm::dot(e, eye), eye.y);
            return scenes::pixel(camera, size,
                                 (major + minor * std::cos(t)) * e + glm::dvec3{0, minor * std::sin(t), 0});
        };
        for (int i = 0; i < 360; ++i) {
            const glm::dvec2 along = glm::normalize(at(i + 0.1) - at(i - 0.1));
            outline.pixels.push_back(at(i));
            outline.normals.emplace_back(-along.y, along.x);
        }
        for (const double width : {1.0, 3.5}) {
            SCOPED_TRACE(testing::Message() << "elevation " << elevation << ", width " << width);
            const Maps maps = renderer().render(scene, camera, ink(size, width));
            expectCentred(ink_measures::inkOf(maps.picture), outline, width);
        }
    }
}

TEST_P(Ink, runsToThePicturesBorder) {
    const Camera camera = cameraOn(true);
    for (const double width : widths) {
        ink_measures::Difference border;
        for (int i = 0; i < angleCount; ++i) {
            // A half-plane whose edge crosses the picture.
            const double degrees = 2.0 * halfAngle(i);
            const double offset = 0.011 * i - 0.15;
            const glm::dvec3 a = turned({-4, offset, 0}, degrees);
            const glm::dvec3 b = turned({4, offset, 0}, degrees);
            const Scene scene =
                scenes::sceneOf(scenes::quad(a, b, turned({4, 4, 0}, degrees), turned({-4, 4, 0}, degrees)));
            const Line edge = lineBetween(camera, square, a, b);
            const Image<double> drawn =
                ink_measures::inkOf(renderer().render(scene, camera, ink(square, width)).picture);
            for (int y = 0; y < square.height; ++y) {
                for (int x = 0; x < square.width; ++x) {
                    const bool atBorder = x == 0 || y == 0 || x == square.width - 1 || y == square.height - 1;
                    if (!atBorder) continue;
                    const double exact = ink_measures::bandCoverage(x, y, edge, width);
                    border.add(drawn.at(x, y), exact);
                    // Where the line itself has left the picture nothing is known of it.
                    const glm::dvec2 from = ink_measures::centre(x, y);
                    const glm::dvec2 nearest = from - glm::dot(from - edge.a, edge.normal()) * edge.normal();
                    const bool seen = nearest.x > 0.5 && nearest.y > 0.5 && nearest.x < square.width - 0.5 &&
                                      nearest.y < square.height - 0.5;
                    if (seen) {
                        EXPECT_LE(exact - drawn.at(x, y), gapLimit) << x << ", " << y << ", width " << width;
                    }
                }
            }
        }
        EXPECT_GT(border.count(), 4 * angleCount);
        EXPECT_LE(border.rms(), ink_measures::cornerRmsLimit) << "width " << width;
    }
}

TEST_P(Ink, neitherThinsOutNorDoublesWhereTypesMeet) {
    // In front of a square stands a strip: its long sides are outline, then occlusion, then outline again.
    const Camera camera = cameraOn(true);
    for (const double degrees : {0.9, 17.0, 40.0, 71.0}) {
        const auto at = [&](double x, double y, double z) { return turned({x + 0.007, y - 0.013, z}, degrees); };
        const Scene scene = scenes::sceneOf(
            {{scenes::quad(at(-0.2, -0.8, 1), at(0.2, -0.8, 1), at(0.2, 0.8, 1), at(-0.2, 0.8, 1)), glm::dmat4{1.0}},
             {scenes::quad(at(-0.6, -0.4, 0), at(0.6, -0.4, 0), at(0.6, 0.4, 0), at(-0.6, 0.4, 0)), glm::dmat4{1.0}}});
        std::vector<Line> lines;
        const auto add = [&](glm::dvec3 a, glm::dvec3 b) { lines.push_back(lineBetween(camera, square, a, b)); };
        add(at(-0.2, -0.8, 1), at(-0.2, 0.8, 1));
        add(at(0.2, -0.8, 1), at(0.2, 0.8, 1));
        add(at(-0.2, -0.8, 1), at(0.2, -0.8, 1));
        add(at(-0.2, 0.8, 1), at(0.2, 0.8, 1));
        for (const double side : {-1.0, 1.0}) {
            add(at(side * 0.6, -0.4, 0), at(side * 0.6, 0.4, 0));
            for (const double end : {-0.4, 0.4}) add(at(side * 0.6, end, 0), at(side * 0.2, end, 0));
        }
        for (const double width : widths) {
            SCOPED_TRACE(testing::Message() << "angle " << degrees << ", width " << width);
            const Maps maps = renderer().render(scene, camera, ink(square, width, {Map::Types}));
            const Image<double> drawn = ink_measures::inkOf(maps.picture);
            unsigned types = 0;
            for (const std::uint16_t t : maps.types.pixels()) types |= t;
            EXPECT_EQ(types & 3U, 3U) << "no two types to meet";
            const Image<double> exact = ink_measures::exactInk(square, lines, width);
            ink_measures::Difference junctions;
            for (const double side : {-1.0, 1.0}) {
                for (const double end : {-0.4, 0.4}) {
                    const glm::dvec2 pixel = scenes::pixel(camera, square, at(side * 0.2, end, 0));
                    ink_measures::compareAround(drawn, exact, pixel, 0.5 * width + 3.0, junctions);
                }
            }
            EXPECT_LE(junctions.rms(), ink_measures::cornerRmsLimit);
            ink_measures::Difference whole;
            for (std::size_t k = 0; k < drawn.pixels().size(); ++k) whole.add(drawn.pixels()[k], exact.pixels()[k]);
            EXPECT_LE(whole.rms(), ink_measures::rmsLimit);
        }
    }
}

TEST_P(Ink, ofACubeHasNoGaps) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (int i = 0; i < angleCount; ++i) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 12.0 * i + 5.0;
        cameraSettings.elevationAngle = 20.0 + i;
        const Camera camera = frameCamera(scene, cameraSettings, square);
        const auto corner = [](int k) {
            return glm::dvec3{(k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1};
        };
        const glm::dvec3 eye{glm::inverse(camera.view)[3]};
        std::vector<Line> lines;
        for (int a = 0; a < 8; ++a) {
            for (int axis = 0; axis < 3; ++axis) {
                if ((a >> axis & 1) != 0) continue;
                const auto shown = [&](int other) { return eye[other] * corner(a)[other] > 1.0; };  // the face's front
                if (!shown((axis + 1) % 3) && !shown((axis + 2) % 3)) continue;
                lines.push_back(lineBetween(camera, square, corner(a), corner(a | 1 << axis)));
            }
        }
        ASSERT_GE(lines.size(), 7U);
        for (const double width : {1.0, 3.5}) {
            SCOPED_TRACE(testing::Message() << "view " << i << ", width " << width);
            const Image<double> drawn =
                ink_measures::inkOf(renderer().render(scene, camera, ink(square, width)).picture);
            const Image<double> exact = ink_measures::exactInk(square, lines, width);
            for (const Line& line : lines) {
                const auto alone = [&](glm::dvec2 p) {
                    return std::ranges::none_of(lines, [&](const Line& other) {
                        return &other != &line && ink_measures::distance(p, other) < 1.5;
                    });
                };
                EXPECT_LE(ink_measures::maxMissing(drawn, exact, line, alone), gapLimit);
                // Lines that run together leave less than a pixel between them, and a tip that no pixel's centre may
                // lie in.
                EXPECT_LE(ink_measures::maxMissing(drawn, exact, line), tipLimit);
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::ink

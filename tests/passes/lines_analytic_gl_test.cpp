// Lines that geometry alone foretells: where they must be, and where none may be.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/load_scene.h>

#include "gl/gl_test.h"
#include "passes/line_maps.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using namespace line_maps;
using testing::Each;

INKEDGE_ON_EACH_BACKEND(Lines);

// A camera at the origin that looks along -Z at a square picture.
Camera straightCamera(double viewAngle, double orthographicHeight) {
    Camera camera;
    camera.viewAngle = viewAngle;
    camera.orthographicHeight = orthographicHeight;
    return camera;
}

// A grid over the part of the plane through (0, 0, -1) that a little more than the picture shows, its inner vertices
// moved about at random, so that its triangles have no order. In the plane but for the rounding of its coordinates to
// float.
Mesh planeBehindPicture(const Camera& camera, glm::dvec3 n, int cells) {
    std::uint32_t state = 1;
    const auto random = [&] { return ((state = state * 1664525U + 1013904223U) >> 8U) / 16777216.0 - 0.5; };
    Mesh mesh;
    mesh.name = "plane";
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            const double x = 1.02 * (2.0 * (i + (inner ? 0.6 * random() : 0.0)) / cells - 1.0);
            const double y = 1.02 * (2.0 * (j + (inner ? 0.6 * random() : 0.0)) / cells - 1.0);
            if (camera.orthographic()) {
                const double half = 0.5 * camera.orthographicHeight;
                mesh.positions.emplace_back(glm::dvec3{x * half, y * half, -1.0 - (n.x * x + n.y * y) * half / n.z});
            } else {
                const double half = std::tan(glm::radians(0.5 * camera.viewAngle));
                const glm::dvec3 ray{x * half, y * half, -1.0};
                mesh.positions.emplace_back(ray * (-n.z / glm::dot(n, ray)));
            }
        }
    }
    const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            mesh.indices.insert(mesh.indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j),
                                                     vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return mesh;
}

TEST_P(Lines, ofATiltedPlaneAreNone) {
    constexpr Size size{121, 121};
    for (const bool orthographic : {false, true}) {
        for (const double tilt : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 80.0, 85.0, 88.0, 89.0, 89.5, 89.9}) {
            // In perspective a steep plane fills a narrow picture only: no ray may run along it.
            const Camera fitted = straightCamera(std::min(50.0, 1.3 * (90.0 - tilt)), orthographic ? 1.0 : 0.0);
            for (const double turn : {0.0, 33.0, 90.0}) {
                for (const int cells : {1, 12}) {
                    SCOPED_TRACE(testing::Message() << (orthographic ? "orthographic" : "perspective") << ", tilted by "
                                                    << tilt << " towards " << turn << ", " << cells << " cells");
                    const double a = glm::radians(tilt);
                    const double b = glm::radians(turn);
                    const glm::dvec3 n{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
                    const Mesh mesh = planeBehindPicture(fitted, n, cells);
                    Camera camera = fitted;
                    camera.near = std::numeric_limits<double>::infinity();
                    camera.far = -std::numeric_limits<double>::infinity();
                    for (const glm::vec3 p : mesh.positions) {
                        camera.near = std::min(camera.near, -static_cast<double>(p.z));
                        camera.far = std::max(camera.far, -static_cast<double>(p.z));
                    }
                    const double margin = 0.01 * (camera.far - camera.near) + 0.01;
                    camera.near = orthographic ? camera.near - margin : 0.9 * camera.near;
                    camera.far += margin;
                    const Maps maps = renderer().render(scenes::sceneOf(mesh), camera, linesOf(size));
                    EXPECT_THAT(maps.types.pixels(), Each(0));
                    EXPECT_THAT(maps.picture.pixels(), Each(255));
                }
            }
        }
    }
}

TEST_P(Lines, ofTwoPlanesThatBendByLessThanTheCreaseAngleAreNone) {
    constexpr Size size{96, 96};
    Camera camera = straightCamera(40.0, 0.0);
    camera.near = 0.1;
    camera.far = 20.0;
    for (const double bend : {32.0, 36.0}) {
        // Tilted until one of them is nearly seen edge on.
        for (const double tilt : {0.0, 40.0, 52.0}) {
            const auto at = [&](double x, double y, double z) {
                return glm::dvec3{scenes::translation({0, 0, -3}) * scenes::rotation(tilt, {0, 1, 0}) *
                                  glm::dvec4{x, y, z, 1}};
            };
            const double fall = std::sin(glm::radians(bend));
            const double run = std::cos(glm::radians(bend));
            Mesh mesh;
            for (const glm::dvec3& p :
                 {at(-1, -2, 0), at(0, -2, 0), at(0, 2, 0), at(-1, 2, 0), at(run, -2, -fall), at(run, 2, -fall)}) {
                mesh.positions.emplace_back(p);
            }
            mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
            const Maps maps = renderer().render(scenes::sceneOf(mesh), camera, linesOf(size));
            const auto creases =
                std::ranges::count_if(maps.types.pixels(), [](unsigned t) { return (t & crease) != 0; });
            if (bend < LoadSettings{}.creaseAngle)
                EXPECT_EQ(creases, 0) << bend << ", " << tilt;
            else
                EXPECT_GE(creases, size.height) << bend << ", " << tilt;
        }
    }
}

// Which pixels lie within a distance of some points.
Image<std::uint8_t> nearPoints(Size size, const std::vector<glm::dvec2>& points, double radius) {
    Image<std::uint8_t> near{size, 1};
    for (const glm::dvec2 p : points) {
        for (int y = std::max(0, static_cast<int>(p.y - radius - 1.0)); y <= std::min(size.height - 1.0, p.y + radius);
             ++y) {
            for (int x = std::max(0, static_cast<int>(p.x - radius - 1.0));
                 x <= std::min(size.width - 1.0, p.x + radius); ++x) {
                if (glm::distance(p, {x + 0.5, y + 0.5}) <= radius) near.at(x, y) = 1;
            }
        }
    }
    return near;
}

void expectMarksOnlyNear(const Maps& maps, const std::vector<glm::dvec2>& points, double distance) {
    const Image<std::uint8_t> near = nearPoints(maps.types.size(), points, distance);
    int marked = 0;
    int off = 0;
    for (std::size_t i = 0; i < near.pixels().size(); ++i) {
        marked += maps.types.pixels()[i] != 0 ? 1 : 0;
        off += maps.types.pixels()[i] != 0 && near.pixels()[i] == 0 ? 1 : 0;
    }
    EXPECT_EQ(off, 0) << "of " << marked << " marked pixels";
    EXPECT_GT(marked, maps.types.size().height / 2);
}

// A mark stands at the pixel on the nearer side: its centre is less than a step from the line, along x or y.
constexpr double markReach = 1.1;

constexpr std::array pictureSides{20, 63, 200, 633, 2000};

TEST_P(Lines, ofASphereAreItsOutlineAtEverySize) {
    // Its faces bend by up to 360 / segments degrees.
    for (const std::uint32_t segments : {24U, 96U}) {
        const Scene scene = scenes::sceneOf(scenes::sphere(1.0, segments));
        for (const bool orthographic : {false, true}) {
            Camera camera = straightCamera(35.0, orthographic ? 2.1 : 0.0);
            const glm::dvec3 middle{0, 0, -3.6};
            camera.view = scenes::translation(middle) * scenes::rotation(37, {1, 0.4, 0.2});
            camera.near = 2.0;
            camera.far = 5.0;
            for (const int side : pictureSides) {
                SCOPED_TRACE(testing::Message() << segments << " segments, " << side << " pixels, "
                                                << (orthographic ? "orthographic" : "perspective"));
                // The circle on which rays from the eye touch the sphere lies this far in front of its centre.
                const double height = orthographic ? 0.0 : 1.0 / 3.6;
                const double radius = std::sqrt(1.0 - height * height);
                Camera inView = camera;
                inView.view = glm::dmat4{1.0};
                std::vector<glm::dvec2> circle;
                for (int i = 0; i < 4 * side + 100; ++i) {
                    const double t = 2.0 * std::numbers::pi * i / (4 * side + 100);
                    circle.push_back(scenes::pixel(
                        inView, {side, side}, middle + glm::dvec3{radius * std::cos(t), radius * std::sin(t), height}));
                }
                // The mesh's contour zigzags along edges that lie up to a face off the circle, which the sphere's curve
                // brings towards the middle by a versine.
                const double zigzag = 0.5 * side * (1.0 - std::cos(2.0 * std::numbers::pi / segments));
                expectMarksOnlyNear(renderer().render(scene, camera, linesOf({side, side})), circle,
                                    markReach + zigzag);
            }
        }
    }
}

// A ring about the y axis, tube circles in planes through the axis.
glm::dvec3 onTorus(double major, double minor, double u, double t) {
    const double r = major + minor * std::cos(t);
    return {r * std::sin(u), minor * std::sin(t), r * std::cos(u)};
}

Mesh torus(double major, double minor, std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    mesh.name = "torus";
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            mesh.positions.emplace_back(
                onTorus(major, minor, 2.0 * std::numbers::pi * i / around, 2.0 * std::numbers::pi * k / across));
            const std::uint32_t next = (i + 1) % around;
            const std::uint32_t up = (k + 1) % across;
            mesh.indices.insert(mesh.indices.end(), {i * across + k, next * across + k, next * across + up,
                                                     i * across + k, next * across + up, i * across + up});
        }
    }
    return mesh;
}

// Where rays from the eye touch the torus: the normal n = cos t e(u) + sin t y and the position p have n . (p - eye) =
// 0, that is (major - e . eye) cos t - eye.y sin t + minor = 0. Hidden parts are among them.
std::vector<glm::dvec2> torusContour(double major, double minor, glm::dvec3 eye, const Camera& camera, Size size) {
    std::vector<glm::dvec2> points;
    const int steps = 12 * size.width;
    for (int i = 0; i < steps; ++i) {
        const double u = 2.0 * std::numbers::pi * i / steps;
        const double c = major - std::sin(u) * eye.x - std::cos(u) * eye.z;
        const double s = -eye.y;
        const double amplitude = std::hypot(c, s);
        if (amplitude < minor) continue;
        for (const double sign : {-1.0, 1.0}) {
            const double t = std::atan2(s, c) + sign * std::acos(-minor / amplitude);
            points.push_back(scenes::pixel(camera, size, onTorus(major, minor, u, t)));
        }
    }
    return points;
}

TEST_P(Lines, ofATorusAreItsContoursAtEverySize) {
    constexpr double major = 1.0;
    constexpr double minor = 0.4;
    constexpr std::uint32_t around = 480;
    const Scene scene = scenes::sceneOf(torus(major, minor, around, 96));
    for (const double elevation : {65.0, 35.0, 12.0}) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 20.0;
        cameraSettings.elevationAngle = elevation;
        for (const int side : pictureSides) {
            const Size size{side, side};
            const Camera camera = frameCamera(scene, cameraSettings, size);
            const glm::dvec3 eye{glm::inverse(camera.view)[3]};
            // The mesh's contour runs along edges, each of which it may take one face beside the smooth one; seen along
            // the surface that matters only at the ends of the inner contour, which it overruns by up to a face.
            const double face = side / (2.2 * (major + minor)) * 2.0 * std::numbers::pi * major / around;
            SCOPED_TRACE(testing::Message() << "elevation " << elevation << ", " << side << " pixels");
            expectMarksOnlyNear(renderer().render(scene, camera, linesOf(size)),
                                torusContour(major, minor, eye, camera, size), markReach + face);
        }
    }
}

TEST_P(Lines, findTheCornerOfAFold) {
    // Figure 1(f): the flap stands off the sheet under it by 8 degrees, so that at the fold's ends depth and normal
    // agree.
    const Scene scene = loadScene(assets + "folded_paper.glb");
    std::vector<glm::dvec3> foldEnds;
    std::vector<glm::dvec3> flapCorners;
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        const bool flap = std::abs(p.y) > 1e-4;
        auto& kind = flap ? flapCorners : foldEnds;
        if (!flap && p.x < 0.0) continue;  // of the lower sheet
        if (std::ranges::none_of(kind, [&](glm::dvec3 q) { return glm::distance(p, q) < 1e-6; })) kind.push_back(p);
    }
    ASSERT_EQ(foldEnds.size(), 2U);
    ASSERT_EQ(flapCorners.size(), 2U);
    constexpr double tipLength = 1.5;  // pixels
    ASSERT_GT(flapCorners[0].y, 0.0);  // seen from above, the flap's whole border is
    constexpr Size size{256, 256};
    for (const bool orthographic : {false, true}) {
        for (const glm::dvec2 angles : {glm::dvec2{20, 45}, {-30, 40}, {20, 70}, {75, 50}, {150, 35}, {0, 85}}) {
            SCOPED_TRACE(testing::Message() << "azimuth " << angles.x << ", elevation " << angles.y);
            CameraSettings cameraSettings;
            cameraSettings.azimuthAngle = angles.x;
            cameraSettings.elevationAngle = angles.y;
            if (orthographic) cameraSettings.orthographicHeight = 0.0;
            const Camera camera = frameCamera(scene, cameraSettings, size);
            const Maps maps = renderer().render(scene, camera, linesOf(size));
            for (const glm::dvec3& end : foldEnds) {
                // Its flap edge leads to the corner on the same side, front or back.
                const glm::dvec3 corner = glm::distance(flapCorners[0], end) < glm::distance(flapCorners[1], end)
                                              ? flapCorners[0]
                                              : flapCorners[1];
                const glm::dvec2 from = scenes::pixel(camera, size, end);
                const glm::dvec2 to = scenes::pixel(camera, size, corner);
                const int steps = static_cast<int>(4.0 * glm::distance(from, to));
                for (int i = 0; i <= steps; ++i) {
                    const glm::dvec2 p = glm::mix(from, to, static_cast<double>(i) / steps);
                    double nearest = 1e9;
                    for (int y = static_cast<int>(p.y) - 2; y <= static_cast<int>(p.y) + 2; ++y) {
                        for (int x = static_cast<int>(p.x) - 2; x <= static_cast<int>(p.x) + 2; ++x) {
                            if (maps.types.at(x, y) != 0)
                                nearest = std::min(nearest, glm::distance(p, {x + 0.5, y + 0.5}));
                        }
                    }
                    // The tips are narrower than a pixel: the first one whose centre they cover lies up to a diagonal
                    // off.
                    const double toTip = 0.25 * std::min(i, steps - i);
                    EXPECT_LE(nearest, toTip < tipLength ? std::numbers::sqrt2 : markReach)
                        << "at " << p.x << ", " << p.y << ", " << 0.25 * i << " from the fold";
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::passes

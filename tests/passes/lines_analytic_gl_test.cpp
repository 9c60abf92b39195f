// Lines that follow from geometry alone: where they must be, and where none may be.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/load_scene.h>

#include "gl/gl_test.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge {
namespace {

using testing::Each;
using testing::ElementsAre;

INKEDGE_ON_EACH_BACKEND(Lines);

const std::string assets = INKEDGE_SOURCE_DIR "/assets/";

constexpr unsigned bit(LineType type) { return static_cast<unsigned>(type); }
constexpr unsigned outline = bit(LineType::Outline);
constexpr unsigned occlusion = bit(LineType::Occlusion);
constexpr unsigned boundary = bit(LineType::Boundary);
constexpr unsigned crease = bit(LineType::Crease);
constexpr unsigned intersection = bit(LineType::Intersection);
constexpr unsigned object = bit(LineType::Object);

Settings linesOf(Size size, std::vector<Map> maps = {Map::Types}) {
    Settings settings;
    settings.picture.size = size;
    settings.maps = std::move(maps);
    return settings;
}

template <class T>
int countMarked(const Image<T>& map) {
    return static_cast<int>(std::ranges::count_if(map.pixels, [](T value) { return value != 0; }));
}

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
                    EXPECT_THAT(maps.types.pixels, Each(0));
                    EXPECT_THAT(maps.picture.pixels, Each(255));
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
    for (const double bend : {28.0, 32.0}) {
        // Tilted until one of them is nearly seen edge on.
        for (const double tilt : {0.0, 40.0, 55.0}) {
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
            const auto creases = std::ranges::count_if(maps.types.pixels, [](unsigned t) { return (t & crease) != 0; });
            if (bend < 30.0)
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
    const Image<std::uint8_t> near = nearPoints(maps.types.size, points, distance);
    int marked = 0;
    int off = 0;
    for (std::size_t i = 0; i < near.pixels.size(); ++i) {
        marked += maps.types.pixels[i] != 0 ? 1 : 0;
        off += maps.types.pixels[i] != 0 && near.pixels[i] == 0 ? 1 : 0;
    }
    EXPECT_EQ(off, 0) << "of " << marked << " marked pixels";
    EXPECT_GT(marked, maps.types.size.height / 2);
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

// A scene whose every instance is moved by one more transform, in double precision.
Scene transformed(const Scene& scene, const glm::dmat4& transform) {
    Scene::Data data;
    data.meshes = scene.meshes();
    data.nodes = scene.nodes();
    data.instances = scene.instances();
    data.nodes = scene.nodes();
    for (Instance& instance : data.instances) instance.transform = transform * instance.transform;
    return Scene{std::move(data)};
}

// The share of line pixels that one picture has and the other has not.
double changedShare(const Maps& a, const Maps& b) {
    int changed = 0;
    for (std::size_t i = 0; i < a.types.pixels.size(); ++i) {
        changed += (a.types.pixels[i] != 0) != (b.types.pixels[i] != 0) ? 1 : 0;
    }
    EXPECT_GT(countMarked(a.types), 500);
    return static_cast<double>(changed) / countMarked(a.types);
}

// Scales and offsets round positions in view space differently, in the last bit of a float: a pixel whose centre an
// edge passes within 1e-4 pixel of may change sides, and a decision that close to its limit may turn.
constexpr double rounding = 0.003;

constexpr Size pictureSize{240, 200};

CameraSettings threeQuarters(bool orthographic) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 33.0;
    cameraSettings.elevationAngle = 24.0;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return cameraSettings;
}

TEST_P(Lines, doNotDependOnTheScenesSizeOrPosition) {
    for (const char* asset : {"gear.glb", "torus_knot.glb", "touching_solids.glb"}) {
        const Scene scene = loadScene(assets + asset);
        for (const bool orthographic : {false, true}) {
            const CameraSettings cameraSettings = threeQuarters(orthographic);
            const Maps original =
                renderer().render(scene, frameCamera(scene, cameraSettings, pictureSize), linesOf(pictureSize));
            const auto compare = [&](const glm::dmat4& transform, double limit, const std::string& what) {
                const Scene other = transformed(scene, transform);
                const Maps maps =
                    renderer().render(other, frameCamera(other, cameraSettings, pictureSize), linesOf(pictureSize));
                EXPECT_LE(changedShare(original, maps), limit) << asset << ' ' << what;
            };
            for (const double scale : {1e-4, 0.37, 1e4}) {
                compare(scenes::scaling(glm::dvec3{scale}), rounding, "scaled by " + std::to_string(scale));
            }
            const double far = 1e6 * scene.bounds().radius;
            compare(scenes::translation({far, -0.7 * far, 0.3 * far}), rounding, "moved by a million radii");
            compare(scenes::scaling(glm::dvec3{1e-4}) * scenes::translation({-far, far, far}), rounding,
                    "scaled and moved");
        }
    }
}

TEST_P(Lines, doNotDependOnNearAndFar) {
    const Scene scene = loadScene(assets + "gear.glb");
    for (const bool orthographic : {false, true}) {
        const Camera camera = frameCamera(scene, threeQuarters(orthographic), pictureSize);
        const Maps original = renderer().render(scene, camera, linesOf(pictureSize));
        // Reversed float depth in perspective keeps its precision; an orthographic view's is spread evenly over its
        // range.
        for (const double factor : orthographic ? std::vector{3.0, 30.0} : std::vector{10.0, 1e3}) {
            Camera moved = camera;
            moved.near = orthographic ? camera.near - factor * scene.bounds().radius : camera.near / factor;
            moved.far = orthographic ? camera.far + factor * scene.bounds().radius : camera.far * factor;
            EXPECT_LE(changedShare(original, renderer().render(scene, moved, linesOf(pictureSize))), rounding)
                << factor;
        }
    }
}

// A camera on +Z that shows -2..2 at 32 pixels per unit; world (0, 0) lies between pixels 63 and 64.
constexpr Size square{128, 128};
Camera flatCamera() {
    Camera camera;
    camera.view = scenes::translation({0, 0, -10});
    camera.orthographicHeight = 4.0;
    camera.near = 5.0;
    camera.far = 15.0;
    return camera;
}

struct Ids {
    std::uint32_t patch;
    std::uint32_t across;
    std::uint32_t node;
    std::uint32_t material;
    friend bool operator==(const Ids&, const Ids&) = default;
};
Ids idsAt(const Maps& maps, int x, int y) {
    return {maps.ids.at(x, y, 0), maps.ids.at(x, y, 1), maps.ids.at(x, y, 2), maps.ids.at(x, y, 3)};
}

unsigned typesIn(const Maps& maps) {
    unsigned all = 0;
    for (const std::uint16_t t : maps.types.pixels) all |= t;
    return all;
}

TEST_P(Lines, ofACubeAreOutlineAndCrease) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const bool orthographic : {false, true}) {
        const Maps maps = renderer().render(scene, frameCamera(scene, threeQuarters(orthographic), pictureSize),
                                            linesOf(pictureSize));
        EXPECT_EQ(typesIn(maps), outline | crease);
    }
}

TEST_P(Lines, ofASheetsBorderAreBoundaries) {
    const Mesh sheet = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const Maps alone = renderer().render(scenes::sceneOf(sheet), flatCamera(), linesOf(square));
    EXPECT_THAT(alone.types.pixels, Each(testing::AnyOf(0, static_cast<int>(outline | boundary))));
    // 64 pixels along each side, corners once: the marks are on the sheet's side.
    EXPECT_EQ(countMarked(alone.types), 4 * 64 - 4);
    EXPECT_EQ(alone.types.at(32, 64), outline | boundary);
    EXPECT_EQ(alone.types.at(31, 64), 0);
    // Over another sheet of the same node it hides part of that.
    Mesh two = sheet;
    for (const glm::vec3 p : sheet.positions) two.positions.push_back(0.5F * p + glm::vec3{0, 0, 1});
    for (const std::uint32_t i : sheet.indices) two.indices.push_back(4 + i);
    const Maps over = renderer().render(scenes::sceneOf(two), flatCamera(), linesOf(square));
    EXPECT_EQ(over.types.at(48, 64), occlusion | boundary);
    EXPECT_EQ(over.types.at(47, 64), 0);
    EXPECT_EQ(over.types.at(32, 64), outline | boundary);
}

TEST_P(Lines, ofBoxesDistinguishOcclusionFromIntersectionAndNodesFromNodes) {
    // One box in front of another, and one that runs half into the first.
    const Scene scene = scenes::sceneOf(
        {{scenes::box({1, 1, 1}), scenes::translation({0, 0, 2})},
         {scenes::box({2, 2, 1}), scenes::translation({0.5, 0, 0})},
         {scenes::box({1, 0.5, 0.5}), scenes::translation({-0.5, 0, 2.25}) * scenes::rotation(30, {0, 1, 0})}});
    const Maps maps = renderer().render(scene, flatCamera(), linesOf(square, {Map::Types, Map::Ids}));
    // The first box's right side, at x = 0.5, pixel 80, hides the second.
    EXPECT_EQ(maps.types.at(79, 70), occlusion | object);
    EXPECT_EQ(idsAt(maps, 79, 70).node, 1U);
    EXPECT_EQ(idsAt(maps, 80, 70).node, 2U);
    EXPECT_EQ(idsAt(maps, 79, 70).across, idsAt(maps, 80, 70).patch);
    EXPECT_EQ(idsAt(maps, 80, 70).across, idsAt(maps, 79, 70).patch);
    EXPECT_NE(idsAt(maps, 80, 70).patch, idsAt(maps, 79, 70).patch);
    // The third, turned, dips into the first one's front.
    int intersections = 0;
    for (int y = 0; y < square.height; ++y) {
        for (int x = 0; x < square.width; ++x) {
            if ((maps.types.at(x, y) & intersection) == 0) continue;
            ++intersections;
            EXPECT_EQ(maps.types.at(x, y) & object, object);
            EXPECT_THAT(idsAt(maps, x, y).node, testing::AnyOf(1U, 3U));
        }
    }
    EXPECT_GE(intersections, 10);
}

TEST_P(Lines, haveTheIdsOfBothSides) {
    // Two quads in one mesh of two materials that meet in a ridge, and a third behind, of another node without
    // material.
    Mesh roof;
    roof.positions = {{-1, -1, 0}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}};
    roof.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    roof.materials = {5, 5, 7, 7};
    const Mesh wall = scenes::quad({-1.5, -1.5, -2}, {1.5, -1.5, -2}, {1.5, 1.5, -2}, {-1.5, 1.5, -2});
    const Scene scene = scenes::sceneOf({{roof, glm::dmat4{1.0}}, {wall, glm::dmat4{1.0}}});
    for (const int supersampling : {1, 2}) {
        Settings settings = linesOf(square, {Map::Types, Map::Ids});
        settings.picture.supersampling = supersampling;
        const Maps maps = renderer().render(scene, flatCamera(), settings);
        EXPECT_EQ(idsAt(maps, 40, 64), (Ids{1, 0, 1, 5})) << "left";
        EXPECT_EQ(idsAt(maps, 90, 64), (Ids{2, 0, 1, 7})) << "right";
        EXPECT_EQ(idsAt(maps, 63, 64), (Ids{1, 2, 1, 5})) << "left of the ridge";
        EXPECT_EQ(idsAt(maps, 64, 64), (Ids{2, 1, 1, 7})) << "right of the ridge";
        EXPECT_EQ(idsAt(maps, 95, 64), (Ids{2, 3, 1, 7})) << "before the wall";
        EXPECT_EQ(idsAt(maps, 96, 64).node, 2U) << "on the wall";
        EXPECT_EQ(idsAt(maps, 108, 64), (Ids{3, 0, 2, 0})) << "on the wall";
        EXPECT_EQ(idsAt(maps, 5, 5), (Ids{0, 0, 0, 0})) << "background";
        EXPECT_EQ(maps.types.at(63, 64) | maps.types.at(64, 64), crease);
        EXPECT_EQ(maps.types.at(95, 64), occlusion | boundary | object);
    }
}

TEST_P(Lines, areDrawnAsAskedAndCountedWhetherDrawnOrNot) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frameCamera(scene, threeQuarters(false), pictureSize);
    Settings settings = linesOf(pictureSize, {Map::Types, Map::Edges});
    const Maps all = renderer().render(scene, camera, settings);
    settings.picture.lines = LineType::Crease;
    const Maps creases = renderer().render(scene, camera, settings);
    settings.picture.lines = LineType::Outline;
    const Maps outlines = renderer().render(scene, camera, settings);
    settings.picture.lines = {};
    const Maps none = renderer().render(scene, camera, settings);
    EXPECT_EQ(creases.types.pixels, all.types.pixels);
    EXPECT_THAT(none.picture.pixels, Each(255));
    EXPECT_THAT(none.edges.pixels, Each(0));
    int drawn = 0;
    for (std::size_t i = 0; i < all.types.pixels.size(); ++i) {
        ASSERT_EQ(all.edges.pixels[i] != 0, all.types.pixels[i] != 0);
        ASSERT_EQ(creases.edges.pixels[i] != 0, (all.types.pixels[i] & crease) != 0);
        ASSERT_EQ(outlines.edges.pixels[i] != 0, (all.types.pixels[i] & outline) != 0);
        // Together they are the whole, but where a crease runs into the outline.
        drawn += std::min(creases.picture.pixels[i], outlines.picture.pixels[i]) == all.picture.pixels[i] ? 0 : 1;
    }
    EXPECT_LE(drawn, 7 * 16);  // each of the cube's seven corners in view: a cell and the ink about it
    EXPECT_LT(countMarked(creases.edges), countMarked(outlines.edges));
}

TEST_P(Lines, agreeWhateverTheSupersampling) {
    for (const char* asset : {"gear.glb", "bracket.glb"}) {
        const Scene scene = loadScene(assets + asset);
        const Camera camera = frameCamera(scene, threeQuarters(false), pictureSize);
        Settings settings = linesOf(pictureSize);
        std::vector<Maps> maps;
        for (const int samples : {1, 2, 4}) {
            settings.picture.supersampling = samples;
            maps.push_back(renderer().render(scene, camera, settings));
        }
        const auto ink = [](const Maps& m) {
            double sum = 0.0;
            for (const std::uint8_t p : m.picture.pixels) sum += 255.0 - p;
            return sum;
        };
        for (std::size_t i = 1; i < maps.size(); ++i) {
            SCOPED_TRACE(testing::Message() << asset << ", " << i);
            ASSERT_EQ(maps[i].picture.size, pictureSize);
            ASSERT_EQ(maps[i].types.size, pictureSize);
            // More samples find more where lines stand closer than a pixel, and draw none of the others anew.
            EXPECT_NEAR(ink(maps[i]) / ink(maps[0]), 1.0, 0.06);
            int lost = 0;
            int dark = 0;
            for (std::size_t k = 0; k < maps[0].picture.pixels.size(); ++k) {
                dark += maps[0].picture.pixels[k] < 64 ? 1 : 0;
                lost += maps[0].picture.pixels[k] < 64 && maps[i].picture.pixels[k] > 192 ? 1 : 0;
            }
            EXPECT_GT(dark, 1000);
            EXPECT_LE(lost, dark / 200);
        }
    }
}

// Marked pixels that hang together over sides and corners, each by the larger side of its box.
std::vector<int> extentsOfComponents(const Image<std::uint8_t>& mask) {
    std::vector<int> extents;
    Image<std::uint8_t> left = mask;
    std::vector<glm::ivec2> open;
    for (int y = 0; y < mask.size.height; ++y) {
        for (int x = 0; x < mask.size.width; ++x) {
            if (left.at(x, y) == 0) continue;
            glm::ivec2 low{x, y};
            glm::ivec2 high{x, y};
            open.assign(1, {x, y});
            left.at(x, y) = 0;
            while (!open.empty()) {
                const glm::ivec2 p = open.back();
                open.pop_back();
                low = glm::min(low, p);
                high = glm::max(high, p);
                for (int j = std::max(0, p.y - 1); j <= std::min(mask.size.height - 1, p.y + 1); ++j) {
                    for (int i = std::max(0, p.x - 1); i <= std::min(mask.size.width - 1, p.x + 1); ++i) {
                        if (left.at(i, j) == 0) continue;
                        left.at(i, j) = 0;
                        open.emplace_back(i, j);
                    }
                }
            }
            extents.push_back(std::max(high.x - low.x, high.y - low.y) + 1);
        }
    }
    return extents;
}

TEST_P(Lines, ofBodiesLetIntoAnotherAreTheBordersOfEachTop) {
    // Two boxes side by side in a third, all tops in one plane: as many layers on both sides of the joint, other ones.
    const Scene scene = scenes::sceneOf({{scenes::box({3, 3, 1}), glm::dmat4{1.0}},
                                         {scenes::box({0.8, 1, 0.5}), scenes::translation({-0.4, 0, 0.25})},
                                         {scenes::box({0.8, 1, 0.5}), scenes::translation({0.4, 0, 0.25})}});
    const Maps maps = renderer().render(scene, flatCamera(), linesOf(square));
    // 32 pixels per unit: joints at -0.8, 0 and 0.8, the outline at -1.5 and 1.5. A mark stands on either side.
    for (const int y : {50, 64, 77}) {
        std::vector<int> marked;
        for (int x = 0; x < square.width; ++x) {
            if (maps.types.at(x, y) != 0) marked.push_back(x);
        }
        EXPECT_THAT(marked,
                    ElementsAre(16, testing::AnyOf(37, 38), testing::AnyOf(63, 64), testing::AnyOf(89, 90), 111))
            << y;
    }
}

TEST_P(Lines, ofSolidsThatTouchInAPlaneDoNotSpeckle) {
    const Scene scene = loadScene(assets + "touching_solids.glb");
    for (int view = 0; view < 24; ++view) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 15.0 * view + 3.7;
        cameraSettings.elevationAngle = -50.0 + 6.0 * view;
        if (view % 2 == 1) cameraSettings.orthographicHeight = 0.0;
        const Maps maps = renderer().render(scene, frameCamera(scene, cameraSettings, pictureSize),
                                            linesOf(pictureSize, {Map::Edges}));
        const std::vector<int> extents = extentsOfComponents(maps.edges);
        EXPECT_THAT(extents, Each(testing::Ge(3))) << "view " << view;
        EXPECT_THAT(extents.size(), testing::AllOf(testing::Ge(1U), testing::Le(12U)))
            << "view " << view;  // a few dozen lines, most of which meet
    }
}

}  // namespace
}  // namespace inkedge

// Pictures that geometry alone foretells.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "passes/flat_view.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using flat_view::flatCamera;
using flat_view::square;
using gl_test::classic;
using gl_test::classicMaps;
using testing::Each;

INKEDGE_ON_EACH_BACKEND(AnalyticScene);

struct Segment {
    glm::dvec2 a;
    glm::dvec2 b;
};

double distance(glm::dvec2 p, const Segment& s) {
    const glm::dvec2 along = s.b - s.a;
    const double t = std::clamp(glm::dot(p - s.a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(p, s.a + t * along);
}

// How far the nearest pixel of a mask lies from a point: centre to point, in pixels.
double nearestMark(const Image<std::uint8_t>& mask, glm::dvec2 p) {
    double nearest = std::numeric_limits<double>::infinity();
    const int x0 = static_cast<int>(p.x);
    const int y0 = static_cast<int>(p.y);
    for (int y = std::max(0, y0 - 4); y <= std::min(mask.size().height - 1, y0 + 4); ++y) {
        for (int x = std::max(0, x0 - 4); x <= std::min(mask.size().width - 1, x0 + 4); ++x) {
            if (mask.at(x, y) != 0) nearest = std::min(nearest, glm::distance(p, {x + 0.5, y + 0.5}));
        }
    }
    return nearest;
}

// Everywhere along the lines a mark is near, and everywhere a mark is, a line is near.
void expectLines(const Image<std::uint8_t>& mask, const std::vector<Segment>& lines, double markNearLine,
                 double lineNearMark) {
    for (const Segment& line : lines) {
        const int samples = static_cast<int>(2.0 * glm::distance(line.a, line.b)) + 1;
        for (int i = 0; i <= samples; ++i) {
            const glm::dvec2 p = glm::mix(line.a, line.b, static_cast<double>(i) / samples);
            EXPECT_LE(nearestMark(mask, p), markNearLine) << "at " << p.x << ", " << p.y;
        }
    }
    for (int y = 0; y < mask.size().height; ++y) {
        for (int x = 0; x < mask.size().width; ++x) {
            if (mask.at(x, y) == 0) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const Segment& line : lines) nearest = std::min(nearest, distance({x + 0.5, y + 0.5}, line));
            EXPECT_LE(nearest, lineNearMark) << "at " << x << ", " << y;
        }
    }
}

// A kernel of radius r answers where a pixel's centre and one of the (2 r + 1)^2 around it lie on two sides of a line:
// the centre is then at most sqrt(2) r from it. The tenth is for vertices that snap to a grid of 1/256 pixel.
double kernelReach(Kernel kernel) { return std::sqrt(2.0) * (kernel == Kernel::Sobel ? 1.0 : 2.0) + 0.1; }
// Of the pixels along a line those whose centre lies within half a diagonal of it have a neighbour on the other side.
// Where lines cross at an angle, one of these may see too little change; the next one then does.
constexpr double lineReach = 1.5;

TEST_P(AnalyticScene, tiltedPlaneHasNoEdgeInWindowDepth) {
    constexpr Size size{128, 128};
    Camera camera;
    camera.viewAngle = 50.0;
    const double half = std::tan(glm::radians(25.0));
    for (const double tilt : {0.0, 30.0, 50.0, 54.0}) {
        for (const double turn : {0.0, 30.0, 45.0, 90.0}) {
            SCOPED_TRACE(testing::Message() << "tilted by " << tilt << " towards " << turn);
            // The plane through (0, 0, -1) with normal n; its points on the rays through a frame around the picture.
            const glm::dvec3 n{std::sin(glm::radians(tilt)) * std::cos(glm::radians(turn)),
                               std::sin(glm::radians(tilt)) * std::sin(glm::radians(turn)),
                               std::cos(glm::radians(tilt))};
            const auto onPlane = [&](double x, double y) {
                const glm::dvec3 ray{x * half, y * half, -1.0};
                return ray * (glm::dot(n, glm::dvec3{0, 0, -1}) / glm::dot(n, ray));
            };
            const Mesh mesh =
                scenes::quad(onPlane(-1.01, -1.01), onPlane(1.01, -1.01), onPlane(1.01, 1.01), onPlane(-1.01, 1.01));
            camera.near = std::numeric_limits<double>::infinity();
            camera.far = 0.0;
            for (const glm::vec3 p : mesh.positions) {
                camera.near = std::min(camera.near, -0.99 * static_cast<double>(p.z));
                camera.far = std::max(camera.far, -1.01 * static_cast<double>(p.z));
            }
            const Scene scene = scenes::sceneOf(mesh);
            for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
                Settings settings = classic(size, classicMaps);
                settings.detector.kernel = kernel;
                settings.detector.depthMap = DepthMap::Window;
                const Maps maps = renderer().render(scene, camera, settings);
                EXPECT_THAT(maps.depthEdges.pixels(), Each(0));
                EXPECT_THAT(maps.normalEdges.pixels(), Each(0));
                // Window depth is linear in the picture, so that its gradient is the same everywhere, off the border.
                const float middle = maps.depthMagnitude.at(64, 64);
                for (int y = 2; y < size.height - 2; ++y) {
                    for (int x = 2; x < size.width - 2; ++x) {
                        // Eye depth is stored in float and divided by again: 1e-6 of depths up to 1, times the
                        // kernel's 8.
                        EXPECT_NEAR(maps.depthMagnitude.at(x, y), middle, 1e-5) << x << ", " << y;
                    }
                }
                // In linear depth a steep plane is not even: the measure above shows it.
                if (tilt < 50.0) continue;
                settings.detector.depthMap = DepthMap::Linear;
                const Maps linear = renderer().render(scene, camera, settings);
                EXPECT_GT(std::ranges::max(linear.depthMagnitude.pixels()), 2.0F * linear.depthMagnitude.at(64, 64));
            }
        }
    }
}

constexpr int cubeEdges[12][2]{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                               {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

glm::dvec3 cubeCorner(int i) { return {(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1}; }

TEST_P(AnalyticScene, cubeShowsItsNineVisibleEdges) {
    constexpr Size size{320, 256};
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const bool orthographic : {false, true}) {
        for (const double azimuth : {35.0, -50.0}) {
            CameraSettings cameraSettings;
            cameraSettings.azimuthAngle = azimuth;
            cameraSettings.elevationAngle = 30.0;
            if (orthographic) cameraSettings.orthographicHeight = 0.0;
            const Camera camera = frameCamera(scene, cameraSettings, size);
            // From above, of the bottom's corners the one that lies farthest off is hidden, and so are its three edges.
            int hidden = 0;
            for (int i = 0; i < 8; ++i) {
                const auto depth = [&](int corner) { return -(camera.view * glm::dvec4{cubeCorner(corner), 1.0}).z; };
                if (depth(i) > depth(hidden)) hidden = i;
            }
            std::vector<Segment> lines;
            for (const auto& [a, b] : cubeEdges) {
                if (a == hidden || b == hidden) continue;
                lines.push_back(
                    {scenes::pixel(camera, size, cubeCorner(a)), scenes::pixel(camera, size, cubeCorner(b))});
            }
            ASSERT_EQ(lines.size(), 9U);
            for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
                SCOPED_TRACE(testing::Message() << (orthographic ? "orthographic" : "perspective") << " from "
                                                << azimuth << (kernel == Kernel::Sobel ? ", sobel" : ", farid"));
                Settings settings = classic(size, classicMaps);
                settings.detector.kernel = kernel;
                // The paper's limit: in a picture this small a foreshortened face is as steep as a jump of 0.1 would
                // be. At this T, the same step under both kernels, it is not.
                settings.detector.depthThreshold = kernel == Kernel::Sobel ? 0.3F : 0.3F * 0.388734F / 4.0F;
                const Maps maps = renderer().render(scene, camera, settings);
                expectLines(maps.edges, lines, lineReach, kernelReach(kernel));
            }
        }
    }
}

std::vector<Segment> rectangle(const Camera& camera, glm::dvec2 low, glm::dvec2 high) {
    const auto p = [&](double x, double y) { return scenes::pixel(camera, square, {x, y, 0}); };
    return {{p(low.x, low.y), p(high.x, low.y)},
            {p(high.x, low.y), p(high.x, high.y)},
            {p(high.x, high.y), p(low.x, high.y)},
            {p(low.x, high.y), p(low.x, low.y)}};
}

TEST_P(AnalyticScene, boxInFrontHidesTheOutlineOfTheOneBehind) {
    const Camera camera = flatCamera();
    // Seen along their sides, both show one face, and both faces the same normal: only depth differs.
    const Scene scene = scenes::sceneOf({{scenes::box({1.5, 1.5, 1}), scenes::translation({-0.5, -0.5, 1.5})},
                                         {scenes::box({2.1, 2.1, 1}), scenes::translation({0.5, 0.5, -1.5})}});
    // The front one's whole outline, and the other's from where it comes out: at (0.25, -0.55) and (-0.55, 0.25).
    std::vector<Segment> lines = rectangle(camera, {-1.25, -1.25}, {0.25, 0.25});
    const auto p = [&](double x, double y) { return scenes::pixel(camera, square, {x, y, 0}); };
    lines.push_back({p(0.25, -0.55), p(1.55, -0.55)});
    lines.push_back({p(1.55, -0.55), p(1.55, 1.55)});
    lines.push_back({p(1.55, 1.55), p(-0.55, 1.55)});
    lines.push_back({p(-0.55, 1.55), p(-0.55, 0.25)});
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        Settings settings = classic(square, classicMaps);
        settings.detector.kernel = kernel;
        const Maps maps = renderer().render(scene, camera, settings);
        expectLines(maps.depthEdges, lines, lineReach, kernelReach(kernel));
        expectLines(maps.edges, lines, lineReach, kernelReach(kernel));
        // The normal map does not see where the boxes overlap: a mark in the middle of the front one's upper edge
        // would.
        EXPECT_GT(nearestMark(maps.normalEdges, p(0.0, 0.25)), 4.0);
    }
}

TEST_P(AnalyticScene, roofHasItsRidgeInTheNormalMapOnly) {
    const Camera camera = flatCamera();
    Mesh roof;
    roof.name = "roof";
    roof.positions = {{-1.2F, -1, 0}, {0, -1, 0.4F}, {0, 1, 0.4F}, {-1.2F, 1, 0}, {1.2F, -1, 0}, {1.2F, 1, 0}};
    roof.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    const Scene scene = scenes::sceneOf(roof);
    const auto p = [&](double x, double y) { return scenes::pixel(camera, square, {x, y, 0}); };
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        Settings settings = classic(square, classicMaps);
        settings.detector.kernel = kernel;
        const Maps maps = renderer().render(scene, camera, settings);
        const std::vector<Segment> outline = rectangle(camera, {-1.2, -1}, {1.2, 1});
        std::vector<Segment> withRidge = outline;
        withRidge.push_back({p(0, -1), p(0, 1)});
        expectLines(maps.depthEdges, outline, lineReach, kernelReach(kernel));
        expectLines(maps.normalEdges, withRidge, lineReach, kernelReach(kernel));
        expectLines(maps.edges, withRidge, lineReach, kernelReach(kernel));
    }
}

TEST_P(AnalyticScene, boxesAtOneDepthWithOneNormalShowNoLineBetweenThem) {
    // The limit of both maps, which the paper names: surfaces that differ in neither have no edge between them.
    const Camera camera = flatCamera();
    const Scene scene = scenes::sceneOf({{scenes::box({1, 2, 1}), scenes::translation({-0.5, 0, 0})},
                                         {scenes::box({1, 2, 1}), scenes::translation({0.5, 0, 0})}});
    Settings settings = classic(square, classicMaps);
    const Maps maps = renderer().render(scene, camera, settings);
    expectLines(maps.edges, rectangle(camera, {-1, -1}, {1, 1}), lineReach, kernelReach(Kernel::Sobel));
}

}  // namespace
}  // namespace inkedge::passes

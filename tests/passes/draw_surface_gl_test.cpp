#include "passes/draw_surface.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using gl_test::classic;

INKEDGE_ON_EACH_BACKEND(DrawSurface);

// Half a step of 8 bits: what rounding light to RGBA8 may change.
constexpr double halfStep = 1.0 / 510.0;
// The processor interpolates in float along a plane equation through the picture: a0 + x dx + y dy, each term rounded,
// where x dx may be many times the value itself. Measured on llvmpipe, up to 60 degrees from facing the eye: 1e-6.
constexpr double floatInterpolation = 1e-5;
// On a surface seen at a grazing angle the slopes dx, dy are steep and magnify the rounding of the vertices' positions,
// which processors snap to a grid of 1/256 pixel.
constexpr double snapping = 1.0 / 256.0;

Camera look(const Scene& scene, bool orthographic, Size size) {
    CameraSettings cameraSettings;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return frameCamera(scene, cameraSettings, size);
}

Maps draw(Renderer& renderer, const Scene& scene, const Camera& camera, Size size,
          NormalLights lights = NormalLights::Single, LightSpace space = LightSpace::Camera) {
    Settings settings = classic(size, {Map::Depth, Map::Normal});
    settings.detector.normalLights = lights;
    settings.detector.lightSpace = space;
    settings.normalSpace = space == LightSpace::World ? NormalSpace::World : NormalSpace::Camera;
    return renderer.render(scene, camera, settings);
}

// The point of view space that a pixel's centre shows at this depth.
glm::dvec3 viewPoint(const Camera& camera, Size size, int x, int y, double depth) {
    const glm::dvec2 ndc{2.0 * (x + 0.5) / size.width - 1.0, 1.0 - 2.0 * (y + 0.5) / size.height};
    const double half = camera.orthographic() ? camera.orthographicHeight / 2.0
                                              : depth * std::tan(glm::radians(camera.viewAngle) / 2.0);
    return {ndc.x * half * size.width / size.height, ndc.y * half, -depth};
}

glm::dvec3 at(const Image<float>& normals, int x, int y) {
    return {normals.at(x, y, 0), normals.at(x, y, 1), normals.at(x, y, 2)};
}
glm::dvec3 at(const Image<double>& normals, int x, int y) {
    return {normals.at(x, y, 0), normals.at(x, y, 1), normals.at(x, y, 2)};
}
double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The length of all edges of all triangles in the picture, in pixels.
double edgeLength(const Scene& scene, const Camera& camera, Size size) {
    const std::vector<glm::dvec3> corners = scenes::drawnVertices(scene);
    double length = 0.0;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            length += glm::distance(scenes::pixel(camera, size, corners[t + i]),
                                    scenes::pixel(camera, size, corners[t + (i + 1) % 3]));
        }
    }
    return length;
}

struct Difference {
    int pixels = 0;     // with a surface in both
    int coverage = 0;   // with a surface in one only
    int atEdges = 0;    // over the tolerances
    double normal = 0;  // the largest within them
    double depth = 0;
    double windowDepth = 0;
};

constexpr double depthTolerance = 1e-5;  // of the distance from near to far
constexpr double windowTolerance = 1e-5;

Difference compareWithReference(const Maps& maps, const Scene& scene, LightSpace space, double normalTolerance) {
    const Camera& camera = maps.camera;
    const reference::Surface expected = reference::drawSurface(scene, camera, space, maps.depth.size());
    Difference result;
    for (int y = 0; y < maps.depth.size().height; ++y) {
        for (int x = 0; x < maps.depth.size().width; ++x) {
            const bool drawn = at(maps.normal, x, y) != glm::dvec3{0.0};
            const bool expectedDrawn = at(expected.normal, x, y) != glm::dvec3{0.0};
            if (drawn != expectedDrawn) ++result.coverage;
            if (!drawn || !expectedDrawn) continue;
            ++result.pixels;
            const double normal = largest(at(maps.normal, x, y) - at(expected.normal, x, y));
            const double depth = std::abs(maps.depth.at(x, y) - expected.depth.at(x, y)) / (camera.far - camera.near);
            const double window = std::abs(maps.windowDepth.at(x, y) - expected.windowDepth.at(x, y));
            if (normal > normalTolerance || depth > depthTolerance || window > windowTolerance) {
                ++result.atEdges;
                continue;
            }
            result.normal = std::max(result.normal, normal);
            result.depth = std::max(result.depth, depth);
            result.windowDepth = std::max(result.windowDepth, window);
        }
    }
    return result;
}

void expectEqualsReference(const Maps& maps, const Scene& scene, LightSpace space, double normalTolerance) {
    const Difference found = compareWithReference(maps, scene, space, normalTolerance);
    // Pixels whose centre lies within 1/256 pixel of a triangle's edge, on either side, may fall to the neighbour:
    // 2/256 of the edges' length in pixels. The sum has most edges twice, once for each of their triangles, and half
    // are hidden: that is the margin.
    const double bound = snapping * edgeLength(scene, maps.camera, maps.depth.size());
    EXPECT_GT(found.pixels, maps.depth.size().width * maps.depth.size().height / 10) << "enough to see something";
    EXPECT_LE(found.coverage + found.atEdges, bound)
        << found.coverage << " differ in coverage, " << found.atEdges << " in value, of " << found.pixels;
}

struct View {
    bool orthographic;
    LightSpace space;
};
const std::vector<View> views{
    {false, LightSpace::Camera}, {false, LightSpace::World}, {true, LightSpace::Camera}, {true, LightSpace::World}};

TEST_P(DrawSurface, givesASphereTheNormalsOfItsPoints) {
    constexpr Size size{128, 96};
    // A vertex's normal points away from the centre; so does, at any point of a facet, the normal interpolated
    // linearly.
    const Scene scene =
        scenes::sceneOf(scenes::sphere(2.0, 64), scenes::translation({5, -3, 1}) * scenes::rotation(25, {1, 1, 0}));
    for (const auto& [orthographic, space] : views) {
        const Camera camera = look(scene, orthographic, size);
        const reference::Surface surface = reference::drawSurface(scene, camera, space, size);
        const glm::dvec3 centre{camera.view * glm::dvec4{5, -3, 1, 1}};
        const glm::dmat3 toLights =
            space == LightSpace::Camera ? glm::dmat3{1.0} : glm::transpose(glm::dmat3{camera.view});
        for (const NormalLights lights : {NormalLights::Single, NormalLights::TwoPass}) {
            const Maps maps = draw(renderer(), scene, camera, size, lights, space);
            const double tolerance = floatInterpolation + (lights == NormalLights::TwoPass ? halfStep : 0.0);
            const double radius = size.height * 0.46;  // of the sphere, in pixels: it is framed at 92 %
            int compared = 0;
            int facing = 0;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const bool expectedDrawn = surface.depth.at(x, y) < camera.far;
                    if (!expectedDrawn || at(maps.normal, x, y) == glm::dvec3{0.0}) continue;
                    const glm::dvec3 point = viewPoint(camera, size, x, y, surface.depth.at(x, y));
                    const glm::dvec3 normal = glm::normalize(point - centre);
                    const glm::dvec3 toEye = orthographic ? glm::dvec3{0, 0, 1} : glm::normalize(-point);
                    const double cosine = glm::dot(normal, toEye);
                    const double difference = largest(at(maps.normal, x, y) - toLights * normal);
                    ++compared;
                    // Per pixel the normal turns by 1 / (radius cosine).
                    const bool grazing = cosine < 0.5;
                    facing += grazing ? 0 : 1;
                    EXPECT_LE(difference, tolerance + (grazing ? snapping / (radius * std::max(cosine, 1e-3)) : 0.0))
                        << x << ", " << y << ", seen at a cosine of " << cosine;
                }
            }
            EXPECT_GT(facing, 0.7 * compared);
        }
    }
}

TEST_P(DrawSurface, givesAFineSphereTheNormalsOfATrueOne) {
    constexpr Size size{96, 96};
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 128));
    const Camera camera = look(scene, true, size);
    const Maps maps = draw(renderer(), scene, camera, size);
    const glm::dvec3 centre{camera.view * glm::dvec4{0, 0, 0, 1}};
    // Facets are 2.8 degrees wide; the middle of one's diagonal lies 1 - cos(2 degrees) = 6e-4 inside the sphere. Seen
    // at an angle a from its normal, that moves the point along the surface by 6e-4 tan(a): 1.04e-3 at 60 degrees.
    constexpr double chord = 1.05e-3;
    int compared = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 p = viewPoint(camera, size, x, y, 0.0) - centre;
            const double z = std::sqrt(std::max(0.0, 1.0 - p.x * p.x - p.y * p.y));
            if (z < 0.5) continue;
            EXPECT_LE(largest(at(maps.normal, x, y) - glm::dvec3{p.x, p.y, z}), chord) << x << ", " << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, 4000);
}

TEST_P(DrawSurface, lightsTheInsideOfASphereFromInside) {
    constexpr Size size{64, 64};
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 128));
    CameraSettings cameraSettings;
    cameraSettings.position = glm::dvec3{0.2, 0, 0};
    cameraSettings.direction = glm::dvec3{0, 0, -1};
    cameraSettings.viewAngle = 60.0;
    const Camera camera = frameCamera(scene, cameraSettings, size);
    const Maps maps = draw(renderer(), scene, camera, size);
    const reference::Surface surface = reference::drawSurface(scene, camera, LightSpace::Camera, size);
    const glm::dvec3 centre{camera.view * glm::dvec4{0, 0, 0, 1}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 outward = glm::normalize(viewPoint(camera, size, x, y, surface.depth.at(x, y)) - centre);
            EXPECT_LE(largest(at(maps.normal, x, y) + outward), floatInterpolation) << x << ", " << y;
        }
    }
}

TEST_P(DrawSurface, givesNormalsUnitLength) {
    constexpr Size size{96, 96};
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 16), scenes::scaling({3, 0.01, 1}));
    const Maps maps = draw(renderer(), scene, look(scene, false, size), size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double length = glm::length(at(maps.normal, x, y));
            if (length == 0.0) continue;
            EXPECT_NEAR(length, 1.0, 1e-6) << "three floats, rounded once each after division by a rounded length";
        }
    }
}

// Each of these transforms must turn normals as it turns surfaces.
std::vector<std::pair<std::string, glm::dmat4>> oddTransforms() {
    glm::dmat4 shear{1.0};
    shear[1][0] = 0.8;
    shear[2][1] = -0.6;
    const glm::dmat4 turn = scenes::rotation(35, {1, 2, 3});
    return {{"mirrored in x", turn * scenes::scaling({-1, 1, 1})},
            {"mirrored in y", turn * scenes::scaling({1, -1, 1})},
            {"mirrored in z", turn * scenes::scaling({1, 1, -1})},
            {"turned inside out", turn * scenes::scaling({-1, -1, -1})},
            {"stretched", turn * scenes::scaling({3, 1, 0.4}) * scenes::rotation(50, {0, 1, 1})},
            {"sheared", turn * shear},
            {"sheared, stretched and mirrored", shear * scenes::scaling({2, -1, 0.5}) * turn},
            {"large and far off", scenes::translation({1e5, -2e5, 3e5}) * scenes::scaling(glm::dvec3{1e4}) * turn}};
}

TEST_P(DrawSurface, equalsItsDefinitionUnderEveryTransform) {
    constexpr Size size{96, 96};
    for (const auto& [name, transform] : oddTransforms()) {
        for (const auto& [orthographic, space] : views) {
            SCOPED_TRACE(name + (orthographic ? ", orthographic" : ", perspective") +
                         (space == LightSpace::World ? ", world lights" : ", camera lights"));
            const Scene scene =
                scenes::sceneOf({{scenes::box({2, 1, 3}), transform},
                                 {scenes::sphere(1.0, 16), transform * scenes::translation({1.5, 0.5, 0})}});
            const Maps maps =
                draw(renderer(), scene, look(scene, orthographic, size), size, NormalLights::Single, space);
            expectEqualsReference(maps, scene, space, floatInterpolation);
        }
    }
}

TEST_P(DrawSurface, equalsItsDefinitionInTwoPasses) {
    constexpr Size size{96, 96};
    for (const auto& [orthographic, space] : views) {
        SCOPED_TRACE(std::string{orthographic ? "orthographic" : "perspective"});
        const Scene scene = scenes::sceneOf({{scenes::cube(), scenes::rotation(20, {1, 2, 3})},
                                             {scenes::sphere(1.0, 16), scenes::translation({1, 1, 0})}});
        const Maps maps = draw(renderer(), scene, look(scene, orthographic, size), size, NormalLights::TwoPass, space);
        expectEqualsReference(maps, scene, space, floatInterpolation + halfStep);
    }
}

TEST_P(DrawSurface, drawsEveryInstanceOfAMeshWhereItBelongs) {
    constexpr Size size{128, 128};
    Scene::Data data;
    data.meshes = {scenes::box({1, 0.6, 0.8}), scenes::sphere(0.5, 12)};
    data.meshes[1].origin = {0.1, 0.2, -0.1};
    // Mirrored and plain ones mixed, so that the order of drawing is not that of the scene.
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 position{i % 4 - 1.5, i / 4 - 1.0, 0.1 * i};
        data.instances.push_back({"", static_cast<std::uint32_t>(i % 2),
                                  scenes::translation(1.4 * position) * scenes::rotation(25.0 * i, {1, 1, 0}) *
                                      scenes::scaling({i % 3 == 0 ? -1 : 1, 1, 1})});
    }
    const Scene scene{data};
    for (const bool orthographic : {false, true}) {
        const Maps maps = draw(renderer(), scene, look(scene, orthographic, size), size);
        expectEqualsReference(maps, scene, LightSpace::Camera, floatInterpolation);
    }
}

TEST_P(DrawSurface, keepsTheNearestSurfaceWhateverTheOrder) {
    const Mesh front = scenes::quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
    const Mesh behind = scenes::quad({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1});
    Camera camera;
    camera.view = scenes::translation({0, 0, -5});
    camera.near = 1.0;
    camera.far = 9.0;
    for (const double height : {0.0, 2.0}) {
        camera.orthographicHeight = height;
        camera.viewAngle = 20.0;
        for (const auto& order : {std::pair{front, behind}, std::pair{behind, front}}) {
            const Scene scene = scenes::sceneOf({{order.first, glm::dmat4{1.0}}, {order.second, glm::dmat4{1.0}}});
            const Maps maps = draw(renderer(), scene, camera, {8, 8});
            EXPECT_THAT(maps.depth.pixels(), testing::Each(testing::FloatNear(4.0F, 1e-5F)));
        }
    }
}

TEST_P(DrawSurface, leavesTheBackgroundAsDocumented) {
    constexpr Size size{32, 32};
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const bool orthographic : {false, true}) {
        const Camera camera = look(scene, orthographic, size);
        for (const NormalLights lights : {NormalLights::Single, NormalLights::TwoPass}) {
            const Maps maps = draw(renderer(), scene, camera, size, lights);
            for (const auto& [x, y] : {std::pair{0, 0}, std::pair{31, 0}, std::pair{0, 31}, std::pair{31, 31}}) {
                EXPECT_FLOAT_EQ(maps.depth.at(x, y), static_cast<float>(camera.far));
                EXPECT_EQ(maps.windowDepth.at(x, y), 1.0F);
                EXPECT_EQ(at(maps.normal, x, y), glm::dvec3(0.0));
            }
        }
    }
}

TEST_P(DrawSurface, keepsDepthPreciseWhereNearAndFarAreFarApart) {
    constexpr Size size{64, 64};
    // A floor that begins below the camera and ends a thousand times as far away; near / far is 1e-4.
    const Scene scene =
        scenes::sceneOf(scenes::quad({-50, -0.05, 50}, {50, -0.05, 50}, {50, -0.05, -50}, {-50, -0.05, -50}));
    CameraSettings cameraSettings;
    cameraSettings.position = glm::dvec3{0, 0, 0};
    cameraSettings.direction = glm::dvec3{0, 0, -1};
    cameraSettings.viewAngle = 60.0;
    const Camera camera = frameCamera(scene, cameraSettings, size);
    ASSERT_LE(camera.near / camera.far, 1.01e-4);
    const reference::Surface surface = reference::drawSurface(scene, camera, LightSpace::Camera, size);
    for (const NormalLights lights : {NormalLights::Single, NormalLights::TwoPass}) {
        const Maps maps = draw(renderer(), scene, camera, size, lights);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const double expected = surface.depth.at(x, y);
                // A float depth buffer that runs from 1 at near to 0 at far has its digits where perspective needs
                // them.
                EXPECT_NEAR(maps.depth.at(x, y) / expected, 1.0, 1e-5) << x << ", " << y;
            }
        }
    }
}

TEST_P(DrawSurface, trustsNoStateThatItFinds) {
    constexpr Size size{40, 40};
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = look(scene, false, size);
    const gl::Current current{context()};
    const gl::Api& api = gpu().api;
    const gl::UploadedScene upload{api, scene};
    DetectorSettings settings;
    settings.detector = Detector::Classic;
    for (const NormalLights lights : {NormalLights::Single, NormalLights::TwoPass}) {
        settings.normalLights = lights;
        const auto surface = [&] {
            const Frame frame = frameOf(gpu(), upload, scene, camera, size);
            return gl::readFloats(api, drawSurface(frame, settings).surface, 4).pixels();
        };
        const std::vector<float> clean = surface();
        // Leaves another picture in the textures that the next draw gets: what it fails to draw will show.
        const Camera other = look(scene, true, size);
        (void)drawSurface(frameOf(gpu(), upload, scene, other, size), settings);
        for (const int on : {GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_DITHER, GL_COLOR_LOGIC_OP,
                             GL_RASTERIZER_DISCARD, GL_DEPTH_CLAMP, GL_POLYGON_OFFSET_FILL, GL_FRAMEBUFFER_SRGB,
                             GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_SAMPLE_MASK}) {
            api.Enable(static_cast<GLenum>(on));
        }
        api.Scissor(1, 1, 3, 3);
        api.Viewport(5, 5, 2, 2);
        api.DepthRange(0.7, 0.2);
        api.DepthFunc(GL_NEVER);
        api.DepthMask(GL_FALSE);
        api.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        api.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        api.FrontFace(GL_CW);
        api.CullFace(GL_FRONT_AND_BACK);
        api.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        api.PolygonOffset(5, 5);
        api.LogicOp(GL_XOR);
        api.BlendFunc(GL_ZERO, GL_ZERO);
        api.UseProgram(0);
        api.BindVertexArray(0);
        api.BindFramebuffer(GL_FRAMEBUFFER, 0);
        api.PixelStorei(GL_PACK_ROW_LENGTH, 7);
        api.PixelStorei(GL_PACK_SKIP_PIXELS, 3);
        EXPECT_EQ(surface(), clean);
        EXPECT_EQ(api.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

}  // namespace
}  // namespace inkedge::passes

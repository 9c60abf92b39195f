#include "passes/detect_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include <inkedge/load_scene.h>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "passes/draw_planes.h"
#include "passes/frame.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

INKEDGE_ON_EACH_BACKEND(DetectLines);

TEST(Marks, areTheSameBitsInTheShaderAndInTheReference) {
    std::ifstream file{INKEDGE_SOURCE_DIR "/shaders/shared/marks.glsl"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const std::regex definition{R"(const uint (\w+) = (\d+)u;)"};
    std::map<std::string, unsigned> found;
    for (std::sregex_iterator i{text.begin(), text.end(), definition}, end; i != end; ++i) {
        found[(*i)[1]] = static_cast<unsigned>(std::stoul((*i)[2]));
    }
    const std::map<std::string, unsigned> expected{{"BACKGROUND", raster::PairMark::background},
                                                   {"PATCH", raster::PairMark::patch},
                                                   {"BEND", raster::PairMark::bend},
                                                   {"JUMP", raster::PairMark::jump}};
    EXPECT_EQ(found, expected);
}

struct Comparison {
    int decisions = 0;   // pairs of neighbours that both see a surface, or one of the two
    int different = 0;   // bits that differ
    unsigned found = 0;  // all bits that the reference has
};

// Triangles of all sizes and attitudes that run through each other.
Scene randomScene(unsigned seed) {
    std::mt19937 random{seed};
    std::uniform_real_distribution<float> coordinate{-1.0F, 1.0F};
    std::uniform_real_distribution<float> size{0.02F, 0.8F};
    Mesh mesh;
    for (std::uint32_t t = 0; t < 120; ++t) {
        const glm::vec3 middle{coordinate(random), coordinate(random), coordinate(random)};
        const float extent = size(random);
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.positions.push_back(middle +
                                     extent * glm::vec3{coordinate(random), coordinate(random), coordinate(random)});
            mesh.indices.push_back(3 * t + k);
        }
    }
    return scenes::sceneOf(mesh);
}

class Comparer {
public:
    Comparer(gl::Gpu& gpu, const Scene& scene) : gpu_{gpu}, scene_{scene}, upload_{gpu.api, scene} {}

    Comparison compare(const Camera& camera, Size size, double creaseAngle) {
        const Frame frame = frameOf(gpu_, upload_, scene_, camera, size);
        const PlaneBuffers buffers = drawPlanes(frame);
        const Image<std::uint8_t> marks = detectLines(frame, buffers.planes, creaseAngle);
        const Image<float> planes = gl::readFloats(gpu_.api, buffers.planes, 4);
        const double focal =
            0.5 * size.height * camera.projection(size)[1][1] * (camera.orthographic() ? frame.unit : 1.0);
        const Image<std::uint8_t> expected = reference::detectLines(planes, focal, camera.orthographic(), creaseAngle,
                                                                    camera.orthographic() ? 1.0 : camera.pixelAspect);
        EXPECT_EQ(marks.size(), size);
        Comparison result;
        if (marks.pixels().size() != expected.pixels().size()) return result;
        constexpr unsigned exactBits =
            (raster::PairMark::background | raster::PairMark::patch) * 0x11U;  // compare ids: no rounding
        for (std::size_t i = 0; i < marks.pixels().size(); ++i) {
            const unsigned difference = marks.pixels()[i] ^ static_cast<unsigned>(expected.pixels()[i]);
            EXPECT_EQ(difference & exactBits, 0U) << "pixel " << i;
            result.different += std::popcount(difference);
            result.decisions += planes.pixels()[4 * i + 3] != 0.0F ? 2 : 0;
            result.found |= expected.pixels()[i];
        }
        return result;
    }

private:
    gl::Gpu& gpu_;
    const Scene& scene_;
    gl::UploadedScene upload_;
};

// Of decisions so close to their limit that float arithmetic (1e-7 of its terms) may take the other side there are few:
// where a bend or a residual is spread over a range of order 1, one in a million; faces seen nearly edge on lose four
// digits more.
constexpr double roundingShare = 1e-4;

TEST_P(DetectLines, equalTheReference) {
    const gl::Current current{context()};
    const std::string assets = INKEDGE_SOURCE_DIR "/assets/";
    std::vector<Scene> all{randomScene(1), randomScene(2), randomScene(3)};
    for (const char* asset :
         {"gear.glb", "blob.glb", "torus_knot.glb", "touching_solids.glb", "teapot.glb", "sheet.glb"}) {
        all.push_back(loadScene(assets + asset));
    }
    Comparison sum;
    for (std::size_t s = 0; s < all.size(); ++s) {
        Comparer comparer{gpu(), all[s]};
        for (const bool orthographic : {false, true}) {
            for (const Size size : {Size{160, 120}, Size{161, 123}, Size{98, 203}}) {
                for (const double angle : {20.0, 30.0, 100.0}) {
                    CameraSettings cameraSettings;
                    cameraSettings.azimuthAngle = 20.0 + 7.0 * static_cast<double>(s);
                    cameraSettings.elevationAngle = angle - 10.0;
                    cameraSettings.zoomFactor = angle < 30.0 ? 4.0 : 1.0;
                    if (orthographic) cameraSettings.orthographicHeight = 0.0;
                    SCOPED_TRACE(testing::Message() << "scene " << s << ", " << size.width << " x " << size.height
                                                    << ", crease angle " << angle);
                    Camera camera = frameCamera(all[s], cameraSettings, size);
                    camera.pixelAspect = size.width == 161 ? 0.6 : 1.0;
                    const Comparison found = comparer.compare(camera, size, angle);
                    EXPECT_LE(found.different, 2 + roundingShare * found.decisions);
                    sum.decisions += found.decisions;
                    sum.different += found.different;
                    sum.found |= found.found;
                }
            }
        }
    }
    EXPECT_GT(sum.decisions, 1'000'000);
    EXPECT_LE(sum.different, roundingShare * sum.decisions);
    EXPECT_EQ(sum.found, 0xFFU) << "some kind of line was never met";
    RecordProperty("different", sum.different);
    RecordProperty("decisions", sum.decisions);
}

TEST_P(DetectLines, equalTheReferenceInPicturesOfAnySize) {
    const gl::Current current{context()};
    const Scene scene = randomScene(4);
    Comparer comparer{gpu(), scene};
    for (const Size size :
         {Size{1, 1}, Size{3, 2}, Size{1, 9}, Size{9, 1}, Size{4, 4}, Size{5, 4}, Size{4, 5}, Size{7, 6}, Size{8, 3}}) {
        SCOPED_TRACE(testing::Message() << size.width << " x " << size.height);
        const Comparison found = comparer.compare(frameCamera(scene, {}, size), size, 30.0);
        EXPECT_EQ(found.different, 0);
    }
}

TEST_P(DetectLines, takeTheCreaseAngleTheyAreGiven) {
    // A roof that bends by 60 degrees within one patch: its faces' normals alone say so. Crease angles over 90 degrees
    // too.
    const gl::Current current{context()};
    Camera camera;
    camera.view = scenes::translation({0, 0, -10});
    camera.orthographicHeight = 2.0;
    camera.near = 5.0;
    camera.far = 15.0;
    constexpr Size size{32, 32};
    for (const double bend : {60.0, 120.0}) {
        const double fall = std::tan(glm::radians(0.5 * bend));
        Mesh roof;
        for (const glm::dvec3& p : {glm::dvec3{-2, -2, -2 * fall},
                                    {0, -2, 0},
                                    {0, 2, 0},
                                    {-2, 2, -2 * fall},
                                    {2, -2, -2 * fall},
                                    {2, 2, -2 * fall}}) {
            roof.positions.emplace_back(p);
        }
        roof.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
        Scene::Data data;
        data.meshes.push_back(roof);
        data.instances.push_back({"roof", 0, glm::dmat4{1.0}});
        const Scene scene{std::move(data), LoadSettings{Normals::Auto, Creases::Auto, 180.0}};
        const gl::UploadedScene upload{gpu().api, scene};
        camera.near = -20.0;
        const Frame frame = frameOf(gpu(), upload, scene, camera, size);
        const PlaneBuffers buffers = drawPlanes(frame);
        for (const double angle : {bend - 0.5, bend + 0.5}) {
            const Image<std::uint8_t> marks = detectLines(frame, buffers.planes, angle);
            for (int y = 0; y < size.height; ++y) {
                EXPECT_EQ(marks.at(15, y), angle < bend ? raster::PairMark::bend : 0U) << bend << ", " << angle;
                EXPECT_EQ(marks.at(14, y), 0U);
            }
        }
    }
}

// How many regions hold a pixel.
int holding(const std::vector<raster::Rectangle>& regions, int x, int y) {
    return static_cast<int>(std::ranges::count_if(regions, [&](const raster::Rectangle& r) {
        return x >= r.x && x < r.x + r.size.width && y >= r.y && y < r.y + r.size.height;
    }));
}

TEST(RegionsAround, holdMarkedPixelsAndTheirNeighboursOnce) {
    for (const Size size : {Size{1, 1}, Size{5, 130}, Size{203, 129}, Size{64, 64}}) {
        std::mt19937 random{7};
        for (int count = 0; count < 6; ++count) {
            Image<std::uint8_t> marks{size, 1};
            for (int i = 0; i < count; ++i) marks.mutablePixels()[random() % marks.pixels().size()] = 16;
            const std::vector<raster::Rectangle> regions = regionsAround(marks);
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    EXPECT_LE(holding(regions, x, y), 1);
                    if (marks.at(x, y) == 0) continue;
                    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.height - 1); ++v) {
                        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.width - 1); ++u) {
                            EXPECT_EQ(holding(regions, u, v), 1) << u << ", " << v << " beside " << x << ", " << y;
                        }
                    }
                }
            }
            for (const raster::Rectangle& r : regions) {
                EXPECT_GE(r.x, 0);
                EXPECT_LE(r.x + r.size.width, size.width);
                EXPECT_LE(r.y + r.size.height, size.height);
            }
        }
    }
}

TEST_P(DetectLines, whatIsReadOfRegionsIsWhatIsReadOfThePicture) {
    const gl::Current current{context()};
    const Scene scene = randomScene(4);
    const Size size{93, 71};
    const gl::UploadedScene upload{gpu().api, scene};
    const Camera camera = frameCamera(scene, {}, size);
    const PlaneBuffers buffers = drawPlanes(frameOf(gpu(), upload, scene, camera, size));
    const Image<float> planes = gl::readFloats(gpu().api, buffers.planes, 4);
    const Image<std::uint32_t> triangles = gl::readIntegers(gpu().api, buffers.triangles);
    const std::vector<raster::Rectangle> regions{{3, 2, {40, 30}}, {0, 40, {93, 31}}};
    const raster::Samples<float> somePlanes = gl::readFloats(gpu().api, buffers.planes, 4, regions);
    const raster::Samples<std::uint32_t> someTriangles = gl::readIntegers(gpu().api, buffers.triangles, regions);
    for (const raster::Rectangle& r : regions) {
        for (int y = r.y; y < r.y + r.size.height; ++y) {
            for (int x = r.x; x < r.x + r.size.width; ++x) {
                for (int k = 0; k < 4; ++k) ASSERT_EQ(somePlanes(x, y, k), planes(x, y, k)) << x << ", " << y;
                ASSERT_EQ(someTriangles(x, y), triangles(x, y)) << x << ", " << y;
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::passes

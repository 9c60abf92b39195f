#include "passes/detect_edges.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using gl_test::classic;
using gl_test::classicMaps;
using gl_test::toDouble;
using testing::Each;

INKEDGE_ON_EACH_BACKEND(DetectEdges);

// Of the largest magnitude. A sum of 9 or 25 products in float is off by some 25 * 6e-8 of the largest sample, and
// scaling depth between near and far loses (far / (far - near)) * 6e-8 before that.
constexpr double magnitudeTolerance = 1e-5;

// Smooth and sharp, creases and jumps, touching the picture's border when zoomed.
Scene mixedScene() {
    return scenes::sceneOf({{scenes::sphere(1.0, 48), scenes::translation({-1, 0.4, 0.5})},
                            {scenes::box({2, 1, 1.5}), scenes::rotation(30, {1, 2, 0})},
                            {scenes::quad({-3, -1, 3}, {3, -1, 3}, {3, -1, -6}, {-3, -1, -6}), glm::dmat4{1.0}}});
}

double largest(const Image<double>& image) { return *std::ranges::max_element(image.pixels()); }

struct Count {
    int nearThreshold = 0;  // pixels whose magnitude is within rounding of T
    int differing = 0;      // masks that differ there
};

void expectSameMagnitudes(const Image<float>& found, const Image<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    const double bound = magnitudeTolerance * std::max(largest(expected), 0.1);
    double worst = 0.0;
    for (std::size_t i = 0; i < found.pixels().size(); ++i) {
        worst = std::max(worst, std::abs(static_cast<double>(found.pixels()[i]) - expected.pixels()[i]));
    }
    EXPECT_LE(worst, bound);
}

Count expectSameMasks(const Image<std::uint8_t>& found, const Image<std::uint8_t>& expected,
                      const Image<double>& magnitude, double threshold) {
    const double rounding = magnitudeTolerance * std::max(largest(magnitude), 0.1);
    Count count;
    int wrong = 0;
    for (std::size_t i = 0; i < found.pixels().size(); ++i) {
        EXPECT_TRUE(found.pixels()[i] == 0 || found.pixels()[i] == 255);
        const bool near = std::abs(magnitude.pixels()[i] - threshold) <= rounding;
        const bool differs = found.pixels()[i] != expected.pixels()[i];
        if (near) ++count.nearThreshold;
        if (near && differs) ++count.differing;
        if (!near && differs) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << "pixels whose magnitude is not within rounding of T";
    return count;
}

// The mask is exactly what equation 7 makes of the magnitude beside it.
void expectThreshold(const Image<std::uint8_t>& mask, const Image<float>& magnitude, float threshold) {
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        ASSERT_EQ(mask.pixels()[i], magnitude.pixels()[i] >= threshold ? 255 : 0) << magnitude.pixels()[i];
    }
}

Count expectEqualsReference(const Maps& maps, const DetectorSettings& settings) {
    // On the maps that the GPU itself drew, so that nothing differs but the detection.
    const reference::Edges expected =
        reference::detectEdges(toDouble(maps.depth), toDouble(maps.normal), maps.camera, settings);
    expectSameMagnitudes(maps.depthMagnitude, expected.depthMagnitude);
    expectSameMagnitudes(maps.normalMagnitude, expected.normalMagnitude);
    const Thresholds t = thresholds(settings);
    const Count depth =
        expectSameMasks(maps.depthEdges, expected.depthEdges, expected.depthMagnitude, static_cast<double>(t.depth));
    const Count normal = expectSameMasks(maps.normalEdges, expected.normalEdges, expected.normalMagnitude,
                                         static_cast<double>(t.normal));
    expectThreshold(maps.depthEdges, maps.depthMagnitude, t.depth);
    expectThreshold(maps.normalEdges, maps.normalMagnitude, t.normal);
    for (std::size_t i = 0; i < maps.edges.pixels().size(); ++i) {
        EXPECT_EQ(maps.edges.pixels()[i], std::max(maps.depthEdges.pixels()[i], maps.normalEdges.pixels()[i]));
    }
    return {depth.nearThreshold + normal.nearThreshold, depth.differing + normal.differing};
}

long marked(const Image<std::uint8_t>& mask) { return std::ranges::count(mask.pixels(), 255); }

TEST_P(DetectEdges, equalsItsDefinitionOnItsOwnMaps) {
    constexpr Size size{160, 120};
    const Scene scene = mixedScene();
    for (const bool orthographic : {false, true}) {
        for (const double zoom : {1.0, 2.5}) {
            CameraSettings cameraSettings;
            cameraSettings.zoomFactor = zoom;
            if (orthographic) cameraSettings.orthographicHeight = 0.0;
            const Camera camera = frameCamera(scene, cameraSettings, size);
            for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
                for (const DepthMap depthMap : {DepthMap::Linear, DepthMap::Window}) {
                    SCOPED_TRACE(testing::Message() << (orthographic ? "orthographic" : "perspective") << ", zoom "
                                                    << zoom << (kernel == Kernel::Sobel ? ", sobel" : ", farid")
                                                    << (depthMap == DepthMap::Linear ? ", linear" : ", window"));
                    Settings settings = classic(size, classicMaps);
                    settings.detector.kernel = kernel;
                    settings.detector.depthMap = depthMap;
                    const Maps maps = renderer().render(scene, camera, settings);
                    const Count count = expectEqualsReference(maps, settings.detector);
                    EXPECT_GT(marked(maps.depthEdges), 100);
                    EXPECT_GT(marked(maps.normalEdges), 100);
                    EXPECT_LE(count.nearThreshold, 8) << "so few pixels may be left open";
                }
            }
        }
    }
}

TEST_P(DetectEdges, equalsItsDefinitionOnEightBitNormalsAndWorldLights) {
    constexpr Size size{120, 90};
    const Scene scene = mixedScene();
    Settings settings = classic(size, classicMaps);
    settings.detector.normalLights = NormalLights::TwoPass;
    settings.detector.lightSpace = LightSpace::World;
    settings.normalSpace = NormalSpace::World;  // the map that the edges are found in
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        settings.detector.kernel = kernel;
        (void)expectEqualsReference(renderer().render(scene, frameCamera(scene, {}, size), settings),
                                    settings.detector);
    }
}

TEST_P(DetectEdges, heedsEachMapsOwnThreshold) {
    constexpr Size size{96, 96};
    const Scene scene = mixedScene();
    const Camera camera = frameCamera(scene, {}, size);
    Settings settings = classic(size, classicMaps);
    settings.detector.kernel = Kernel::Sobel;
    const auto render = [&](float depth, float normal) {
        settings.detector.depthThreshold = depth;
        settings.detector.normalThreshold = normal;
        Maps maps = renderer().render(scene, camera, settings);
        (void)expectEqualsReference(maps, settings.detector);
        return maps;
    };
    const Maps all = render(0.0F, 0.0F);
    EXPECT_THAT(all.depthEdges.pixels(), Each(255)) << "every magnitude is at least 0";
    EXPECT_THAT(all.normalEdges.pixels(), Each(255));
    const Maps none = render(1e6F, 1e6F);
    EXPECT_THAT(none.edges.pixels(), Each(0));
    const Maps depthOnly = render(0.1F, 1e6F);
    EXPECT_GT(marked(depthOnly.depthEdges), 0);
    EXPECT_EQ(depthOnly.edges, depthOnly.depthEdges);
    const Maps normalOnly = render(1e6F, 1.6F);
    EXPECT_GT(marked(normalOnly.normalEdges), 0);
    EXPECT_EQ(normalOnly.edges, normalOnly.normalEdges);
    EXPECT_EQ(depthOnly.depthMagnitude, normalOnly.depthMagnitude) << "magnitudes know no threshold";
}

TEST_P(DetectEdges, marksTheSamePixelsWhetherMagnitudesAreKeptOrNot) {
    constexpr Size size{96, 96};
    const Scene scene = mixedScene();
    const Camera camera = frameCamera(scene, {}, size);
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        Settings settings = classic(size, {Map::Edges});
        settings.detector.kernel = kernel;
        const Maps without = renderer().render(scene, camera, settings);
        settings.maps = classicMaps;
        EXPECT_EQ(renderer().render(scene, camera, settings).edges.pixels(), without.edges.pixels());
        EXPECT_TRUE(without.depthMagnitude.empty());
    }
}

// Noise in every channel, depth from near to far.
gl::Texture randomSurface(gl::Gpu& gpu, Size size, const Camera& camera, std::mt19937& random) {
    std::uniform_real_distribution<float> normal{-1.0F, 1.0F};
    std::uniform_real_distribution<float> depth{static_cast<float>(camera.near), static_cast<float>(camera.far)};
    Image<float> surface{size, 4};
    for (std::size_t i = 0; i < surface.pixels().size(); ++i) {
        surface.mutablePixels()[i] = i % 4 == 3 ? depth(random) : normal(random);
    }
    gl::Texture texture = gpu.textures.acquire(size, GL_RGBA32F);
    gpu.api.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gpu.api.TextureSubImage2D(texture.id(), 0, 0, 0, size.width, size.height, GL_RGBA, GL_FLOAT,
                              surface.pixels().data());
    return texture;
}

// Marks in blocks and magnitudes pixel by pixel, where every threshold is one of the magnitudes: a bit's difference
// between the two forms of the shader would put that pixel on the other side.
void expectSameInBlocks(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera, DetectorSettings settings,
                        std::mt19937& random) {
    const auto detect = [&] { return detectEdges(gpu, surface, camera, settings, Magnitudes::Keep); };
    const Image<float> first = gl::readFloats(gpu.api, *detect().magnitudes, 2);
    const std::size_t count = first.pixels().size() / 2;
    for (int trial = 0; trial < 8; ++trial) {
        settings.depthThreshold = first.pixels()[2 * (random() % count)];
        settings.normalThreshold = first.pixels()[2 * (random() % count) + 1];
        const EdgeBuffers edges = detect();
        ASSERT_EQ(edges.size, surface.size());
        const Image<float> magnitudes = gl::readFloats(gpu.api, *edges.magnitudes, 2);
        ASSERT_EQ(magnitudes, first) << "magnitudes know no threshold";
        const EdgeMarks marks = readMarks(gpu.api, edges);
        const Image<std::uint8_t> depth = mask(marks, EdgeMarks::depthEdge);
        const Image<std::uint8_t> normal = mask(marks, EdgeMarks::normalEdge);
        int different = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (depth.pixels()[i] != (magnitudes.pixels()[2 * i] >= *settings.depthThreshold ? 255 : 0)) ++different;
            if (normal.pixels()[i] != (magnitudes.pixels()[2 * i + 1] >= *settings.normalThreshold ? 255 : 0))
                ++different;
        }
        EXPECT_EQ(different, 0);
        EXPECT_GT(marked(depth), 0);
        EXPECT_GT(marked(normal), 0);
    }
}

TEST_P(DetectEdges, marksInBlocksWhatItMeasuresPixelByPixel) {
    const gl::Current current{context()};
    std::mt19937 random{1};
    Camera camera;
    camera.near = 0.7;
    camera.far = 23.0;
    for (const Size size : {Size{1, 1}, Size{3, 5}, Size{4, 4}, Size{17, 33}, Size{250, 131}}) {
        for (const bool orthographic : {false, true}) {
            camera.orthographicHeight = orthographic ? 2.0 : 0.0;
            const gl::Texture surface = randomSurface(gpu(), size, camera, random);
            for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
                for (const DepthMap depthMap : {DepthMap::Linear, DepthMap::Window}) {
                    SCOPED_TRACE(testing::Message()
                                 << size.width << "x" << size.height << ", kernel " << static_cast<int>(kernel)
                                 << ", depth map " << static_cast<int>(depthMap));
                    DetectorSettings settings;
                    settings.kernel = kernel;
                    settings.depthMap = depthMap;
                    expectSameInBlocks(gpu(), surface, camera, settings, random);
                }
            }
        }
    }
}

// A tilted plane that reaches over every border of the picture.
struct Ramp {
    Scene scene = scenes::sceneOf(scenes::quad({-9, -9, -9}, {9, -9, 9}, {9, 9, 9}, {-9, 9, -9}));
    Camera camera = [] {
        Camera c;
        c.view = scenes::translation({0, 0, -20});
        c.orthographicHeight = 2.0;
        c.near = 10.0;
        c.far = 30.0;
        return c;
    }();
};

TEST_P(DetectEdges, givesTheBorderWhatRepeatingItImplies) {
    constexpr Size size{24, 16};
    const Ramp ramp;
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        Settings settings = classic(size, classicMaps);
        settings.detector.kernel = kernel;
        const Maps maps = renderer().render(ramp.scene, ramp.camera, settings);
        (void)expectEqualsReference(maps, settings.detector);
        const int radius = kernel == Kernel::Sobel ? 1 : 2;
        const float inside = maps.depthMagnitude.at(12, 8);
        // z = x: over one pixel depth falls by 2 / 16 units of the 20 from near to far. A slope s per pixel has
        // magnitude 8 s under Sobel, and 2 (d1 + 2 d2) s under Farid.
        const double slope = 2.0 / 16.0 / 20.0;
        const double gain = kernel == Kernel::Sobel ? 8.0 : 2.0 * (0.280349 + 2.0 * 0.108385) * 0.999999;
        EXPECT_NEAR(inside, gain * slope, magnitudeTolerance * gain);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                // The plane rises along x alone: the upper and lower borders show nothing, the others a weaker slope.
                const float expected = maps.depthMagnitude.at(x, 8);
                EXPECT_NEAR(maps.depthMagnitude.at(x, y), expected, magnitudeTolerance);
                if (x < radius || x >= size.width - radius) {
                    EXPECT_LT(maps.depthMagnitude.at(x, y), inside);
                } else {
                    EXPECT_NEAR(maps.depthMagnitude.at(x, y), inside, magnitudeTolerance);
                }
                EXPECT_NEAR(maps.normalMagnitude.at(x, y), 0.0, magnitudeTolerance);
            }
        }
        EXPECT_THAT(maps.edges.pixels(), Each(0));
    }
}

TEST_P(DetectEdges, worksOnPicturesSmallerThanTheKernel) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const Size size : {Size{1, 1}, Size{2, 2}, Size{3, 1}, Size{1, 3}, Size{5, 4}}) {
        const Camera camera = frameCamera(scene, {}, size);
        for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
            Settings settings = classic(size, classicMaps);
            settings.detector.kernel = kernel;
            const Maps maps = renderer().render(scene, camera, settings);
            ASSERT_EQ(maps.edges.size(), size);
            (void)expectEqualsReference(maps, settings.detector);
            if (size == Size{1, 1}) {
                EXPECT_NEAR(maps.depthMagnitude.at(0, 0), 0.0, magnitudeTolerance);
                EXPECT_EQ(maps.edges.at(0, 0), 0) << "one pixel has no neighbour to differ from";
            }
        }
    }
}

// The numbers of one array in one branch of shaders/shared/kernels.glsl.
std::vector<double> shaderArray(const std::string& branch, const std::string& name) {
    std::smatch found;
    EXPECT_TRUE(std::regex_search(branch, found, std::regex{name + R"(\[\d\] = float\[\]\(([^)]*)\))"})) << name;
    std::stringstream list{found[1].str()};
    std::vector<double> numbers;
    for (std::string number; std::getline(list, number, ',');) numbers.push_back(std::stod(number));
    return numbers;
}

TEST(Kernels, inTheShaderAreThoseOfTheReference) {
    std::ifstream file{INKEDGE_SOURCE_DIR "/shaders/shared/kernels.glsl"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const std::size_t sobel = text.find("#if KERNEL == KERNEL_SOBEL");
    const std::size_t farid = text.find("#else");
    ASSERT_NE(sobel, std::string::npos);
    ASSERT_LT(sobel, farid);
    const std::string sobelBranch = text.substr(sobel, farid - sobel);
    const std::string faridBranch = text.substr(farid);
    EXPECT_THAT(shaderArray(sobelBranch, "SMOOTHING"), testing::ElementsAreArray(reference::sobelSmoothing));
    EXPECT_THAT(shaderArray(sobelBranch, "DERIVATIVE"), testing::ElementsAreArray(reference::sobelDerivative));
    EXPECT_THAT(shaderArray(faridBranch, "SMOOTHING"), testing::ElementsAreArray(reference::faridSmoothing));
    EXPECT_THAT(shaderArray(faridBranch, "DERIVATIVE"), testing::ElementsAreArray(reference::faridDerivative));
    EXPECT_THAT(sobelBranch, testing::HasSubstr("RADIUS = 1;"));
    EXPECT_THAT(faridBranch, testing::HasSubstr("RADIUS = 2;"));
}

}  // namespace
}  // namespace inkedge::passes

#include "reference/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "scenes.h"

namespace inkedge::reference {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::StrEq;

constexpr double exact = 1e-12;  // sums of a few dozen doubles of order 1: their rounding stays below 1e-14

Image<double> imageOf(Size size, double (*value)(int x, int y)) {
    Image<double> image{size, 1};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) image.at(x, y) = value(x, y);
    }
    return image;
}

std::vector<double> row(const Image<double>& image, int y) {
    const auto begin = image.pixels().begin() + static_cast<std::ptrdiff_t>(y) * image.size().width;
    return {begin, begin + image.size().width};
}

TEST(GradientMagnitude, ofAStepIsFourUnderSobel) {
    const auto across = imageOf({8, 5}, [](int x, int) { return x >= 4 ? 1.0 : 0.0; });
    const auto down = imageOf({5, 8}, [](int, int y) { return y >= 4 ? 1.0 : 0.0; });
    const auto fromAcross = gradientMagnitude(across, 0, Kernel::Sobel);
    const auto fromDown = gradientMagnitude(down, 0, Kernel::Sobel);
    for (int y = 0; y < 5; ++y) EXPECT_THAT(row(fromAcross, y), ElementsAre(0, 0, 0, 4, 4, 0, 0, 0));
    for (int y = 0; y < 8; ++y) EXPECT_THAT(row(fromDown, y), Each(y == 3 || y == 4 ? 4.0 : 0.0));
}

TEST(GradientMagnitude, ofAStepIsTheSumOfTheFaridDerivatives) {
    const auto across = imageOf({10, 5}, [](int x, int) { return x >= 5 ? 1.0 : 0.0; });
    const auto magnitude = gradientMagnitude(across, 0, Kernel::Farid);
    constexpr double smoothing = 2 * 0.036470 + 2 * 0.248968 + 0.429123;  // 0.999999
    for (int y = 0; y < 5; ++y) {
        EXPECT_NEAR(magnitude.at(2, y), 0.0, exact);
        EXPECT_NEAR(magnitude.at(3, y), 0.108385 * smoothing, exact);
        EXPECT_NEAR(magnitude.at(4, y), 0.388734 * smoothing, exact);
        EXPECT_NEAR(magnitude.at(5, y), 0.388734 * smoothing, exact);
        EXPECT_NEAR(magnitude.at(6, y), 0.108385 * smoothing, exact);
        EXPECT_NEAR(magnitude.at(7, y), 0.0, exact);
    }
}

TEST(GradientMagnitude, ofOnePixelIsTheKernelItself) {
    const auto point = imageOf({5, 5}, [](int x, int y) { return x == 2 && y == 2 ? 1.0 : 0.0; });
    const auto sobel = gradientMagnitude(point, 0, Kernel::Sobel);
    const double corner = std::sqrt(2.0);
    EXPECT_THAT(row(sobel, 1), testing::Pointwise(testing::DoubleNear(exact), {0.0, corner, 2.0, corner, 0.0}));
    EXPECT_THAT(row(sobel, 2), testing::Pointwise(testing::DoubleNear(exact), {0.0, 2.0, 0.0, 2.0, 0.0}));
    const auto farid = gradientMagnitude(point, 0, Kernel::Farid);
    EXPECT_NEAR(farid.at(0, 0), std::sqrt(2.0) * 0.108385 * 0.036470, exact);
    EXPECT_NEAR(farid.at(1, 0), std::hypot(0.280349 * 0.036470, 0.248968 * 0.108385), exact);
    EXPECT_NEAR(farid.at(2, 0), 0.429123 * 0.108385, exact);
    EXPECT_NEAR(farid.at(2, 2), 0.0, exact);
}

TEST(GradientMagnitude, repeatsTheBorder) {
    const auto ramp = imageOf({6, 4}, [](int x, int) { return static_cast<double>(x); });
    // Inside, a slope of 1 per pixel spans 2 pixels with weight 4; at the border it spans only 1.
    for (int y = 0; y < 4; ++y) {
        EXPECT_THAT(row(gradientMagnitude(ramp, 0, Kernel::Sobel), y), ElementsAre(4, 8, 8, 8, 8, 4));
    }
    const auto farid = gradientMagnitude(ramp, 0, Kernel::Farid);
    constexpr double smoothing = 0.999999;
    EXPECT_NEAR(farid.at(0, 1), (0.280349 * 1 + 0.108385 * 2) * smoothing, exact);
    EXPECT_NEAR(farid.at(1, 1), (0.280349 * 2 + 0.108385 * 3) * smoothing, exact);
    EXPECT_NEAR(farid.at(2, 1), (0.280349 * 2 + 0.108385 * 4) * smoothing, exact);
}

TEST(GradientMagnitude, ofAFlatImageIsZeroUpToTheBorder) {
    const auto flat = imageOf({4, 3}, [](int, int) { return 7.0; });
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        EXPECT_THAT(gradientMagnitude(flat, 0, kernel).pixels(), Each(testing::DoubleNear(0.0, exact)));
    }
}

TEST(GradientMagnitude, worksOnPicturesSmallerThanTheKernel) {
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        const auto one = imageOf({1, 1}, [](int, int) { return 3.0; });
        EXPECT_THAT(gradientMagnitude(one, 0, kernel).pixels(), Each(testing::DoubleNear(0.0, exact)));
        const auto two = imageOf({2, 1}, [](int x, int) { return static_cast<double>(x); });
        const double step = kernel == Kernel::Sobel ? 4.0 : 0.388734 * 0.999999;
        EXPECT_THAT(gradientMagnitude(two, 0, kernel).pixels(), Each(testing::DoubleNear(step, exact)));
    }
}

TEST(GradientMagnitude, takesTheChannelAskedFor) {
    Image<double> image{{4, 4}, 3};
    for (int y = 0; y < 4; ++y) {
        for (int x = 2; x < 4; ++x) image.at(x, y, 1) = 1.0;
    }
    EXPECT_THAT(gradientMagnitude(image, 0, Kernel::Sobel).pixels(), Each(0.0));
    EXPECT_EQ(gradientMagnitude(image, 1, Kernel::Sobel).at(1, 1), 4.0);
    expectError(Error::Kind::Usage, StrEq("expected a channel below 3, found 3"),
                [&] { (void)gradientMagnitude(image, 3, Kernel::Sobel); });
    expectError(Error::Kind::Usage, StrEq("expected a channel below 3, found -1"),
                [&] { (void)gradientMagnitude(image, -1, Kernel::Sobel); });
}

// The paper's text lost the minus signs of d; a derivative that did not see them would answer to a flat image.
TEST(Kernels, derivativesAreAntisymmetricAndSmoothingIsSymmetric) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(sobelDerivative[i], -sobelDerivative[2 - i]);
        EXPECT_EQ(sobelSmoothing[i], sobelSmoothing[2 - i]);
    }
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(faridDerivative[i], -faridDerivative[4 - i]);
        EXPECT_EQ(faridSmoothing[i], faridSmoothing[4 - i]);
    }
    // Positive to the right of the centre: brighter to the right is a positive gradient.
    EXPECT_EQ(faridDerivative[3], 0.280349);
    EXPECT_EQ(faridDerivative[4], 0.108385);
}

TEST(SixLights, giveTheNormal) {
    for (int i = 0; i < 200; ++i) {
        const double a = 0.1 * i;
        const double b = 0.37 * i;
        const glm::dvec3 n{std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)};
        EXPECT_EQ(sixLights(n), n);
    }
    for (const glm::dvec3 n : {glm::dvec3{1, 0, 0}, glm::dvec3{0, -1, 0}, glm::dvec3{0, 0, 1}}) {
        EXPECT_EQ(sixLights(n), n);
    }
}

Camera cameraBetween(double near, double far, double orthographicHeight = 0.0) {
    Camera camera;
    camera.near = near;
    camera.far = far;
    camera.orthographicHeight = orthographicHeight;
    return camera;
}

TEST(ScaledDepth, runsFromZeroAtNearToOneAtFar) {
    const auto depth = imageOf({3, 1}, [](int x, int) { return 2.0 + 3.0 * x; });  // 2, 5, 8
    for (const double height : {0.0, 1.0}) {
        const Camera camera = cameraBetween(2.0, 8.0, height);
        EXPECT_THAT(scaledDepth(depth, camera, DepthMap::Linear).pixels(), ElementsAre(0.0, 0.5, 1.0));
    }
    // Window depth in perspective is far (z - near) / (z (far - near)): 8 * 3 / (5 * 6) in the middle.
    EXPECT_THAT(scaledDepth(depth, cameraBetween(2.0, 8.0), DepthMap::Window).pixels(),
                ElementsAre(0.0, testing::DoubleNear(0.8, exact), 1.0));
    EXPECT_THAT(scaledDepth(depth, cameraBetween(2.0, 8.0, 1.0), DepthMap::Window).pixels(),
                ElementsAre(0.0, 0.5, 1.0));
}

TEST(ScaledDepth, ofWindowIsTheDepthThatTheProjectionGives) {
    for (const double height : {0.0, 3.0}) {
        const Camera camera = cameraBetween(0.3, 40.0, height);
        for (const double z : {0.3, 0.5, 1.0, 7.0, 40.0}) {
            const glm::dvec3 ndc = scenes::project(camera, {4, 3}, {0.0, 0.0, -z});
            const Image<double> depth{{1, 1}, 1, z};
            EXPECT_NEAR(scaledDepth(depth, camera, DepthMap::Window).at(0, 0), 0.5 * ndc.z + 0.5, exact);
        }
    }
}

TEST(ReferenceEdges, marksAMagnitudeThatEqualsItsThreshold) {
    // Linear depth steps from near to far: magnitude 4 exactly.
    const auto depth = imageOf({6, 3}, [](int x, int) { return x >= 3 ? 2.0 : 1.0; });
    const Image<double> normal{{6, 3}, 3};
    DetectorSettings settings;
    settings.detector = Detector::Classic;
    settings.kernel = Kernel::Sobel;
    settings.depthThreshold = 4.0F;
    const auto at = detectEdges(depth, normal, cameraBetween(1.0, 2.0), settings);
    settings.depthThreshold = std::nextafter(4.0F, 5.0F);
    const auto over = detectEdges(depth, normal, cameraBetween(1.0, 2.0), settings);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 6; ++x) {
            EXPECT_EQ(at.depthEdges.at(x, y), x == 2 || x == 3 ? 255 : 0);
            EXPECT_EQ(over.depthEdges.at(x, y), 0);
        }
    }
}

TEST(ReferenceEdges, areThoseOfEitherMap) {
    const auto depth = imageOf({9, 3}, [](int x, int) { return x >= 3 ? 2.0 : 1.0; });
    Image<double> normal{{9, 3}, 3};
    for (int y = 0; y < 3; ++y) {
        for (int x = 6; x < 9; ++x) normal.at(x, y, 2) = 1.0;
    }
    DetectorSettings settings;
    settings.detector = Detector::Classic;
    settings.kernel = Kernel::Sobel;
    settings.depthThreshold = 1.0F;
    settings.normalThreshold = 1.0F;
    const auto edges = detectEdges(depth, normal, cameraBetween(1.0, 2.0), settings);
    const std::vector<int> depthRow{0, 0, 255, 255, 0, 0, 0, 0, 0};
    const std::vector<int> normalRow{0, 0, 0, 0, 0, 255, 255, 0, 0};
    for (int x = 0; x < 9; ++x) {
        const auto i = static_cast<std::size_t>(x);
        EXPECT_EQ(edges.depthEdges.at(x, 1), depthRow[i]);
        EXPECT_EQ(edges.normalEdges.at(x, 1), normalRow[i]);
        EXPECT_EQ(edges.edges.at(x, 1), std::max(depthRow[i], normalRow[i]));
    }
}

TEST(ReferenceEdges, takesTheLargestOfTheNormalChannelsAndNotTheirSum) {
    Image<double> normal{{6, 3}, 3};
    for (int y = 0; y < 3; ++y) {
        for (int x = 3; x < 6; ++x) {
            normal.at(x, y, 0) = 0.25;
            normal.at(x, y, 1) = -0.5;
            normal.at(x, y, 2) = 0.25;
        }
    }
    DetectorSettings settings;
    settings.detector = Detector::Classic;
    settings.kernel = Kernel::Sobel;
    const auto edges = detectEdges(Image<double>{{6, 3}, 1, 1.0}, normal, cameraBetween(1.0, 2.0), settings);
    EXPECT_EQ(edges.normalMagnitude.at(2, 1), 2.0);
}

TEST(ReferenceEdges, refusesMapsOfDifferentSizes) {
    expectError(Error::Kind::Usage, StrEq("expected a depth and a normal map of one size, found 4x3 and 3x4"), [] {
        (void)detectEdges(Image<double>{{4, 3}, 1}, Image<double>{{3, 4}, 3}, cameraBetween(1, 2), {});
    });
}

TEST(ReferenceSurface, ofASquareIsWhatPerspectiveSays) {
    // A square 2 x 2 at depth 4, seen with a view angle of 90 degrees: it fills the middle quarter of the picture's
    // width.
    const Scene scene = scenes::sceneOf(scenes::quad({-1, -1, -4}, {1, -1, -4}, {1, 1, -4}, {-1, 1, -4}));
    Camera camera = cameraBetween(1.0, 9.0);
    camera.viewAngle = 90.0;
    const auto surface = drawSurface(scene, camera, LightSpace::Camera, {16, 16});
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool inside = x >= 6 && x < 10 && y >= 6 && y < 10;
            EXPECT_NEAR(surface.depth.at(x, y), inside ? 4.0 : 9.0, exact);
            EXPECT_NEAR(surface.windowDepth.at(x, y), inside ? 9.0 * 3.0 / (4.0 * 8.0) : 1.0, exact);
            EXPECT_NEAR(surface.normal.at(x, y, 0), 0.0, exact);
            EXPECT_NEAR(surface.normal.at(x, y, 2), inside ? 1.0 : 0.0, exact);
        }
    }
}

TEST(ReferenceSurface, keepsTheNearestAndTurnsNormalsToTheSideThatIsSeen) {
    const Mesh front = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});  // counter-clockwise from +Z
    Camera camera = cameraBetween(1.0, 9.0, 2.0);
    for (const bool fromBehind : {false, true}) {
        const auto turn = scenes::rotation(fromBehind ? 180.0 : 0.0, {0, 1, 0});
        const Scene scene = scenes::sceneOf(
            {{front, scenes::translation({0, 0, -6}) * turn}, {front, scenes::translation({0, 0, -3}) * turn}});
        const auto surface = drawSurface(scene, camera, LightSpace::World, {4, 4});
        EXPECT_THAT(surface.depth.pixels(), Each(testing::DoubleNear(3.0, exact)));
        EXPECT_NEAR(surface.normal.at(1, 1, 2), 1.0, exact);
    }
}

TEST(ReferenceSurface, drawsWhatReachesBehindTheCamera) {
    // A floor one unit below the camera, from far behind it to far before it: the lower half of the picture.
    const Scene scene = scenes::sceneOf(scenes::quad({-90, -1, 90}, {90, -1, 90}, {90, -1, -90}, {-90, -1, -90}));
    Camera camera = cameraBetween(0.5, 50.0);
    camera.viewAngle = 90.0;
    const auto surface = drawSurface(scene, camera, LightSpace::World, {8, 8});
    for (int y = 0; y < 8; ++y) {
        const double slope = (y + 0.5 - 4.0) / 4.0;  // downwards, per unit of depth
        for (int x = 0; x < 8; ++x) EXPECT_NEAR(surface.depth.at(x, y), slope > 0.0 ? 1.0 / slope : 50.0, 1e-9);
    }
}

TEST(ReferenceComposite, givesTheChannelsThatTheColorsNeed) {
    Image<std::uint8_t> edges{{2, 1}, 1, {0, 255}};
    PictureSettings picture;
    EXPECT_THAT(composite(edges, picture).pixels(), ElementsAre(255, 0));
    picture.lineColor = {1, 2, 3};
    EXPECT_THAT(composite(edges, picture).pixels(), ElementsAre(255, 255, 255, 1, 2, 3));
    picture.background = std::nullopt;
    EXPECT_THAT(composite(edges, picture).pixels(), ElementsAre(1, 2, 3, 0, 1, 2, 3, 255));
}

}  // namespace
}  // namespace inkedge::reference

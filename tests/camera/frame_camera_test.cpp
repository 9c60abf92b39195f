#include <inkedge/camera.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "scenes.h"

namespace inkedge {
namespace {

using testing::StrEq;

constexpr Size square{100, 100};
constexpr double frameShare = 0.92;  // what a framed model fills of the picture's tighter side

// Matrices of doubles with entries of order 1: a few roundings of 1e-16 each.
constexpr double exact = 1e-12;
// After division by a depth, and vertices that went through float.
constexpr double nearlyExact = 1e-9;

// Nothing symmetric: the picture's centre, the bounds' centre and the origin all differ.
Scene skewScene(double scale = 1.0) {
    const auto grow = scenes::scaling(glm::dvec3{scale});
    return scenes::sceneOf(
        {{scenes::box({4, 1, 2}), grow * scenes::translation({3, 1, -2})},
         {scenes::cube(0.5), grow * scenes::translation({0, 3, 1}) * scenes::rotation(40, {1, 2, 3})}});
}

glm::dvec3 position(const Camera& camera) { return glm::dvec3{glm::inverse(camera.view)[3]}; }
glm::dvec3 worldAxis(const Camera& camera, int axis) { return glm::transpose(glm::dmat3{camera.view})[axis]; }
glm::dvec3 forward(const Camera& camera) { return -worldAxis(camera, 2); }
double depthOf(const Camera& camera, glm::dvec3 point) { return -(camera.view * glm::dvec4{point, 1.0}).z; }

void expectNear(glm::dvec3 found, glm::dvec3 expected, double tolerance = exact) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

struct Frame {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// What the model covers, in normalised device coordinates.
Frame covered(const Scene& scene, const Camera& camera, Size size) {
    Frame frame;
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        const glm::dvec2 ndc{scenes::project(camera, size, p)};
        frame.low = glm::min(frame.low, ndc);
        frame.high = glm::max(frame.high, ndc);
    }
    return frame;
}

void expectFramed(const Scene& scene, const Camera& camera, Size size) {
    const Frame frame = covered(scene, camera, size);
    const double widest = std::max({-frame.low.x, -frame.low.y, frame.high.x, frame.high.y});
    EXPECT_NEAR(widest, frameShare, nearlyExact) << "the model fills the frame and no more";
    for (int axis = 0; axis < 2; ++axis) {
        if (std::max(-frame.low[axis], frame.high[axis]) < frameShare - nearlyExact) continue;
        EXPECT_NEAR(frame.low[axis], -frame.high[axis], nearlyExact) << "equal margins on the tighter side";
    }
}

void expectVerticesBetweenNearAndFar(const Scene& scene, const Camera& camera) {
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        EXPECT_GT(depthOf(camera, p), camera.near);
        EXPECT_LT(depthOf(camera, p), camera.far);
    }
}

void expectRefusal(const CameraSettings& wish, const std::string& message) {
    expectError(Error::Kind::Usage, StrEq(message), [&] { (void)frameCamera(skewScene(), wish, square); });
}

TEST(FrameCamera, framesTheWholeModelByDefault) {
    for (const Size size : {square, Size{300, 100}, Size{100, 300}, Size{1, 1}}) {
        const Camera camera = frameCamera(skewScene(), {}, size);
        expectFramed(skewScene(), camera, size);
        expectVerticesBetweenNearAndFar(skewScene(), camera);
    }
}

TEST(FrameCamera, framesTheWholeModelFromEverySideAndAngle) {
    const Scene scene = skewScene();
    for (const double azimuth : {-170.0, -45.0, 0.0, 90.0, 200.0}) {
        for (const double elevation : {-90.0, -30.0, 0.0, 60.0, 90.0}) {
            for (const double viewAngle : {1.0, 35.0, 60.0}) {
                CameraSettings wish;
                wish.azimuthAngle = azimuth;
                wish.elevationAngle = elevation;
                wish.viewAngle = viewAngle;
                const Camera camera = frameCamera(scene, wish, {160, 90});
                expectFramed(scene, camera, {160, 90});
                expectVerticesBetweenNearAndFar(scene, camera);
            }
        }
    }
}

TEST(FrameCamera, keepsClearOfASpikeSharperThanTheViewAngle) {
    // A pyramid 10 tall on a base 1 wide, seen from above its tip.
    Mesh spike = scenes::quad({-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0, -0.5});
    spike.positions.emplace_back(0.0F, 10.0F, 0.0F);
    spike.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    const Scene scene = scenes::sceneOf(spike);
    for (const double viewAngle : {35.0, 120.0}) {
        CameraSettings wish;
        wish.direction = glm::dvec3{0, -1, 0};
        wish.viewAngle = viewAngle;
        const Camera camera = frameCamera(scene, wish, square);
        EXPECT_NEAR(depthOf(camera, {0, 10, 0}), 0.1 * scene.bounds().radius, nearlyExact);
        expectVerticesBetweenNearAndFar(scene, camera);
        const Frame frame = covered(scene, camera, square);
        EXPECT_LT(std::max({-frame.low.x, -frame.low.y, frame.high.x, frame.high.y}), frameShare)
            << "all in the picture";
    }
}

TEST(FrameCamera, looksFromTheThreeQuarterViewByDefault) {
    const Camera camera = frameCamera(skewScene(), {}, square);
    // 30 degrees from the front (+Z) towards +X, 20 degrees above the horizon.
    const double a = glm::radians(30.0);
    const double e = glm::radians(20.0);
    expectNear(forward(camera), -glm::dvec3{std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)});
    EXPECT_NEAR(worldAxis(camera, 0).y, 0.0, exact) << "the horizon is level";
    EXPECT_GT(worldAxis(camera, 1).y, 0.0) << "+Y is up";
    EXPECT_EQ(camera.viewAngle, 35.0);
    EXPECT_FALSE(camera.orthographic());
}

TEST(FrameCamera, viewIsARightHandedRotationWithAShift) {
    CameraSettings wish;
    wish.position = glm::dvec3{3, 4, 5};
    wish.viewUp = glm::dvec3{1, 2, 0};
    for (const CameraSettings& each : {CameraSettings{}, wish}) {
        const glm::dmat4 view = frameCamera(skewScene(), each, square).view;
        const glm::dmat3 turn{view};
        EXPECT_NEAR(glm::determinant(turn), 1.0, exact);
        const glm::dmat3 identity = turn * glm::transpose(turn);
        for (int i = 0; i < 3; ++i) expectNear(identity[i], glm::dmat3{1.0}[i]);
        EXPECT_EQ(glm::transpose(view)[3], glm::dvec4(0, 0, 0, 1));
    }
}

TEST(FrameCamera, standsWhereItIsToldAndLooksAtTheFocalPoint) {
    CameraSettings wish;
    wish.position = glm::dvec3{10, 2, 7};
    wish.focalPoint = glm::dvec3{3, 1, -2};
    const Camera camera = frameCamera(skewScene(), wish, square);
    expectNear(position(camera), {10, 2, 7});
    const glm::dvec3 ndc = scenes::project(camera, square, {3, 1, -2});
    EXPECT_NEAR(ndc.x, 0.0, exact);
    EXPECT_NEAR(ndc.y, 0.0, exact);
    EXPECT_GT(depthOf(camera, {3, 1, -2}), 0.0);
}

TEST(FrameCamera, looksAtTheModelsCentreFromAPositionAlone) {
    const Scene scene = skewScene();
    CameraSettings wish;
    wish.position = glm::dvec3{10, 2, 7};
    const Camera camera = frameCamera(scene, wish, square);
    expectNear(position(camera), {10, 2, 7});
    expectNear(forward(camera), glm::normalize(scene.bounds().centre - glm::dvec3{10, 2, 7}));
}

TEST(FrameCamera, looksAlongADirectionFromAPosition) {
    CameraSettings wish;
    wish.position = glm::dvec3{10, 2, 7};
    wish.direction = glm::dvec3{-2, 0, -2};
    const Camera camera = frameCamera(skewScene(), wish, square);
    expectNear(position(camera), {10, 2, 7});
    expectNear(forward(camera), glm::dvec3{-1, 0, -1} * std::sqrt(0.5));
}

TEST(FrameCamera, framesAlongADirectionOfAnyLength) {
    for (const double length : {1e-6, 1.0, 1e6}) {
        CameraSettings wish;
        wish.direction = length * glm::dvec3{0, -0.6, 0.8};
        const Camera camera = frameCamera(skewScene(), wish, square);
        expectNear(forward(camera), {0, -0.6, 0.8});
        expectFramed(skewScene(), camera, square);
    }
}

TEST(FrameCamera, centresAFocalPointWithoutAPosition) {
    CameraSettings wish;
    wish.focalPoint = glm::dvec3{1, 1, -2};
    const Camera camera = frameCamera(skewScene(), wish, square);
    const glm::dvec3 ndc = scenes::project(camera, square, {1, 1, -2});
    EXPECT_NEAR(ndc.x, 0.0, exact);
    EXPECT_NEAR(ndc.y, 0.0, exact);
    expectNear(forward(camera), forward(frameCamera(skewScene(), {}, square)));
}

TEST(FrameCamera, turnsTheGivenUpUpwards) {
    CameraSettings wish;
    wish.direction = glm::dvec3{0, 0, -1};
    wish.viewUp = glm::dvec3{5, 5, 3};  // need not be across the view direction, nor of unit length
    const Camera camera = frameCamera(skewScene(), wish, square);
    expectNear(worldAxis(camera, 1), glm::dvec3{1, 1, 0} * std::sqrt(0.5));
    expectNear(worldAxis(camera, 0), glm::dvec3{1, -1, 0} * std::sqrt(0.5));
    expectFramed(skewScene(), camera, square);
}

TEST(FrameCamera, takesAzimuthFromTheFrontTowardsPlusX) {
    const auto from = [](double azimuth, double elevation) {
        CameraSettings wish;
        wish.azimuthAngle = azimuth;
        wish.elevationAngle = elevation;
        return -forward(frameCamera(skewScene(), wish, square));
    };
    expectNear(from(0, 0), {0, 0, 1});
    expectNear(from(90, 0), {1, 0, 0});
    expectNear(from(180, 0), {0, 0, -1});
    expectNear(from(-90, 0), {-1, 0, 0});
    expectNear(from(450, 0), {1, 0, 0});
    expectNear(from(0, 90), {0, 1, 0});
    expectNear(from(0, -90), {0, -1, 0});
    expectNear(from(90, 45), glm::dvec3{1, 1, 0} * std::sqrt(0.5));
}

TEST(FrameCamera, fillsInTheAngleThatIsNotGiven) {
    CameraSettings azimuthOnly;
    azimuthOnly.azimuthAngle = 0.0;
    EXPECT_NEAR(forward(frameCamera(skewScene(), azimuthOnly, square)).y, -std::sin(glm::radians(20.0)), exact);
    CameraSettings elevationOnly;
    elevationOnly.elevationAngle = 0.0;
    expectNear(forward(frameCamera(skewScene(), elevationOnly, square)), {-0.5, 0.0, -std::sqrt(0.75)});
}

TEST(FrameCamera, looksStraightDownAndUpWithoutBeingToldWhatIsUp) {
    CameraSettings down;
    down.direction = glm::dvec3{0, -3, 0};
    const Camera fromAbove = frameCamera(skewScene(), down, square);
    expectNear(worldAxis(fromAbove, 0), {1, 0, 0});
    expectNear(worldAxis(fromAbove, 1), {0, 0, -1});  // the front of the model is at the bottom, as on a plan
    expectFramed(skewScene(), fromAbove, square);

    CameraSettings up;
    up.direction = glm::dvec3{0, 1, 0};
    const Camera fromBelow = frameCamera(skewScene(), up, square);
    expectNear(worldAxis(fromBelow, 0), {1, 0, 0});
    expectNear(worldAxis(fromBelow, 1), {0, 0, 1});
    expectFramed(skewScene(), fromBelow, square);
}

TEST(FrameCamera, orthographicHeightIsThePicturesHeight) {
    CameraSettings wish;
    wish.orthographicHeight = 8.0;
    const Camera camera = frameCamera(skewScene(), wish, {200, 100});
    ASSERT_TRUE(camera.orthographic());
    EXPECT_EQ(camera.orthographicHeight, 8.0);
    const glm::dvec3 any = skewScene().bounds().centre;
    const glm::dvec3 a = scenes::project(camera, {200, 100}, any);
    const glm::dvec3 b = scenes::project(camera, {200, 100}, any + 2.0 * worldAxis(camera, 1) + worldAxis(camera, 0));
    EXPECT_NEAR(b.y - a.y, 2.0 * 2.0 / 8.0, exact);
    EXPECT_NEAR(b.x - a.x, 2.0 * 1.0 / 16.0, exact) << "pixels are square";
    // The model stands in the middle.
    const Frame frame = covered(skewScene(), camera, {200, 100});
    EXPECT_NEAR(frame.low.x, -frame.high.x, nearlyExact);
    EXPECT_NEAR(frame.low.y, -frame.high.y, nearlyExact);
    expectVerticesBetweenNearAndFar(skewScene(), camera);
}

TEST(FrameCamera, orthographicHeightZeroFramesTheModel) {
    for (const Size size : {square, Size{300, 100}, Size{100, 300}}) {
        CameraSettings wish;
        wish.orthographicHeight = 0.0;
        const Camera camera = frameCamera(skewScene(), wish, size);
        ASSERT_TRUE(camera.orthographic());
        expectFramed(skewScene(), camera, size);
        expectVerticesBetweenNearAndFar(skewScene(), camera);
    }
}

TEST(FrameCamera, zoomMagnifiesAboutThePicturesCentre) {
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{0.0}, std::optional{8.0}}) {
        for (const double zoom : {0.25, 3.0}) {
            CameraSettings wish;
            wish.orthographicHeight = height;
            const Camera plain = frameCamera(skewScene(), wish, square);
            wish.zoomFactor = zoom;
            const Camera zoomed = frameCamera(skewScene(), wish, square);
            EXPECT_EQ(zoomed.view, plain.view);
            for (const glm::dvec3& p : scenes::drawnVertices(skewScene())) {
                const glm::dvec3 before = scenes::project(plain, square, p);
                const glm::dvec3 after = scenes::project(zoomed, square, p);
                EXPECT_NEAR(after.x, zoom * before.x, nearlyExact);
                EXPECT_NEAR(after.y, zoom * before.y, nearlyExact);
            }
        }
    }
}

Scene sceneWithCameras() {
    Scene::Data data;
    data.meshes.push_back(scenes::cube());
    data.instances.push_back({"cube", 0, glm::dmat4{1.0}});
    data.cameras.push_back({"ahead", scenes::translation({0, 0, 9}), 50.0, 0.0});
    data.cameras.push_back({"side", scenes::translation({7, 0, 0}) * scenes::rotation(90, {0, 1, 0}), 35.0, 4.0});
    return Scene{data};
}

TEST(FrameCamera, takesTheFilesCamera) {
    CameraSettings wish;
    wish.index = 0;
    const Camera ahead = frameCamera(sceneWithCameras(), wish, square);
    expectNear(position(ahead), {0, 0, 9});
    expectNear(forward(ahead), {0, 0, -1});
    EXPECT_NEAR(ahead.viewAngle, 50.0, exact);
    EXPECT_FALSE(ahead.orthographic());
    expectVerticesBetweenNearAndFar(sceneWithCameras(), ahead);

    wish.index = 1;
    const Camera side = frameCamera(sceneWithCameras(), wish, square);
    expectNear(position(side), {7, 0, 0});
    expectNear(forward(side), {-1, 0, 0});
    EXPECT_EQ(side.orthographicHeight, 4.0);
    wish.zoomFactor = 2.0;
    EXPECT_EQ(frameCamera(sceneWithCameras(), wish, square).orthographicHeight, 2.0);
}

TEST(FrameCamera, refusesACameraThatTheFileDoesNotHave) {
    CameraSettings wish;
    wish.index = 2;
    expectError(Error::Kind::Usage, StrEq("camera-index: expected a camera of the file, 0 to below 2, found 2"),
                [&] { (void)frameCamera(sceneWithCameras(), wish, square); });
    wish.index = -1;
    expectError(Error::Kind::Usage, StrEq("camera-index: expected a whole number from 0, found '-1'"),
                [&] { (void)frameCamera(sceneWithCameras(), wish, square); });
}

TEST(FrameCamera, fitsNearAndFarToTheBoundingSphere) {
    const Scene scene = skewScene();
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{0.0}}) {
        CameraSettings wish;
        wish.orthographicHeight = height;
        const Camera camera = frameCamera(scene, wish, square);
        const double centre = depthOf(camera, scene.bounds().centre);
        // A margin of one part in a thousand of the radius keeps the outermost vertex off both planes.
        EXPECT_NEAR(camera.near, centre - 1.001 * scene.bounds().radius, nearlyExact);
        EXPECT_NEAR(camera.far, centre + 1.001 * scene.bounds().radius, nearlyExact);
    }
}

TEST(FrameCamera, meansTheSameForAWatchAndForACity) {
    const Camera camera = frameCamera(skewScene(), {}, square);
    for (const double scale : {1e-4, 1e4}) {
        const Scene scene = skewScene(scale);
        const Camera scaled = frameCamera(scene, {}, square);
        EXPECT_NEAR(scaled.far / scaled.near, camera.far / camera.near, nearlyExact);
        EXPECT_NEAR(scaled.far / scale, camera.far, nearlyExact);
        const auto vertices = scenes::drawnVertices(skewScene());
        const auto grown = scenes::drawnVertices(scene);
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            expectNear(scenes::project(scaled, square, grown[i]), scenes::project(camera, square, vertices[i]),
                       nearlyExact);
        }
    }
}

TEST(FrameCamera, keepsAPositiveNearPlaneInsideTheModel) {
    const Scene scene = skewScene();
    CameraSettings wish;
    wish.position = scene.bounds().centre + glm::dvec3{0.1, 0, 0};
    wish.direction = glm::dvec3{1, 0, 0};
    const Camera camera = frameCamera(scene, wish, square);
    EXPECT_GT(camera.near, 0.0);
    EXPECT_LE(camera.near, 1e-3 * scene.bounds().radius) << "what is close to the camera is not cut off";
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) EXPECT_LT(depthOf(camera, p), camera.far);

    wish.orthographicHeight = 3.0;
    const Camera flat = frameCamera(scene, wish, square);
    EXPECT_EQ(flat.near, 0.0) << "an orthographic camera sees from where it stands";
    EXPECT_GT(flat.far, 0.0);
}

TEST(FrameCamera, staysUsableWithEverythingBehindIt) {
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{3.0}}) {
        for (const double distance : {10.0, 1e6}) {
            CameraSettings wish;
            wish.position = glm::dvec3{0, 0, distance};
            wish.direction = glm::dvec3{0, 0, 1};
            wish.orthographicHeight = height;
            const Camera camera = frameCamera(skewScene(), wish, square);
            EXPECT_LT(camera.near, camera.far);
            EXPECT_GE(camera.near, 0.0);
            EXPECT_TRUE(camera.near > 0.0 || camera.orthographic());
            EXPECT_TRUE(std::isfinite(camera.far));
        }
    }
}

TEST(FrameCamera, staysFiniteForASceneWithoutExtent) {
    Mesh point = scenes::quad({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{0.0}}) {
        CameraSettings wish;
        wish.orthographicHeight = height;
        const Camera camera = frameCamera(scenes::sceneOf(point), wish, square);
        EXPECT_TRUE(std::isfinite(glm::determinant(camera.view)));
        EXPECT_TRUE(std::isfinite(glm::determinant(camera.projection(square))));
        EXPECT_LT(camera.near, camera.far);
    }
}

TEST(FrameCamera, refusesTwoWaysToSayOneThing) {
    const glm::dvec3 v{1, 2, 3};
    CameraSettings wish;
    wish.azimuthAngle = 10.0;
    wish.direction = v;
    expectRefusal(wish, "camera-direction: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.elevationAngle = 10.0;
    wish.direction = v;
    expectRefusal(wish, "camera-direction: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.elevationAngle = 10.0;
    wish.position = v;
    expectRefusal(wish, "camera-position: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.position = v;
    wish.direction = v;
    wish.focalPoint = v;
    expectRefusal(wish,
                  "camera-direction: expected it without both camera-position and camera-focal-point, found both");
    for (int which = 0; which < 6; ++which) {
        wish = {};
        wish.index = 0;
        if (which == 0) wish.position = v;
        if (which == 1) wish.focalPoint = v;
        if (which == 2) wish.direction = v;
        if (which == 3) wish.viewUp = v;
        if (which == 4) wish.azimuthAngle = 1.0;
        if (which == 5) wish.elevationAngle = 1.0;
        expectRefusal(wish, "camera-index: expected it without another camera position or direction, found both");
    }
}

TEST(FrameCamera, refusesACameraInsideOut) {
    CameraSettings wish;
    wish.position = glm::dvec3{1, 2, 3};
    wish.focalPoint = glm::dvec3{1, 2, 3};
    expectRefusal(wish, "camera-position: expected a place other than the focal point, found both at 1,2,3");
    wish = {};
    wish.direction = glm::dvec3{0.0};
    expectRefusal(wish, "camera-direction: expected a direction, found 0,0,0");
    wish.position = glm::dvec3{1, 2, 3};
    expectRefusal(wish, "camera-direction: expected a direction, found 0,0,0");
    wish = {};
    wish.viewUp = glm::dvec3{0.0};
    expectRefusal(wish, "camera-view-up: expected a direction, found 0,0,0");
    wish = {};
    wish.direction = glm::dvec3{0, 0, -2};
    wish.viewUp = glm::dvec3{0, 0, 3};
    expectRefusal(wish, "camera-view-up: expected a direction across the view direction 0,0,-1, found one along it");
}

TEST(FrameCamera, refusesNumbersOutOfRange) {
    CameraSettings wish;
    wish.viewAngle = 0.0;
    expectRefusal(wish, "camera-view-angle: expected degrees over 0 and under 180, found '0'");
    wish.viewAngle = 180.0;
    expectRefusal(wish, "camera-view-angle: expected degrees over 0 and under 180, found '180'");
    wish = {};
    wish.zoomFactor = 0.0;
    expectRefusal(wish, "camera-zoom-factor: expected a number over 0, found '0'");
    wish.zoomFactor = -2.0;
    expectRefusal(wish, "camera-zoom-factor: expected a number over 0, found '-2'");
    wish = {};
    wish.orthographicHeight = -1.0;
    expectRefusal(wish, "camera-orthographic: expected a number from 0 to 1.7976931348623157e+308, found '-1'");
}

TEST(Projection, mapsNearAndFarToTheEndsOfClipSpace) {
    for (const double height : {0.0, 2.0}) {
        Camera camera;
        camera.near = 0.5;
        camera.far = 20.0;
        camera.orthographicHeight = height;
        EXPECT_NEAR(scenes::project(camera, square, {0, 0, -0.5}).z, -1.0, exact);
        EXPECT_NEAR(scenes::project(camera, square, {0, 0, -20.0}).z, 1.0, exact);
    }
}

TEST(Projection, putsTheViewAngleBetweenBottomAndTop) {
    Camera camera;
    camera.viewAngle = 60.0;
    camera.near = 1.0;
    camera.far = 10.0;
    const double edge = 4.0 * std::tan(glm::radians(30.0));
    EXPECT_NEAR(scenes::project(camera, {300, 100}, {0, edge, -4}).y, 1.0, exact);
    EXPECT_NEAR(scenes::project(camera, {300, 100}, {3.0 * edge, 0, -4}).x, 1.0, exact);
    EXPECT_NEAR(scenes::project(camera, {100, 200}, {0.5 * edge, 0, -4}).x, 1.0, exact);
}

}  // namespace
}  // namespace inkedge

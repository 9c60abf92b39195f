#include <inkedge/camera.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;

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
                CameraSettings wanted;
                wanted.azimuthAngle = azimuth;
                wanted.elevationAngle = elevation;
                wanted.viewAngle = viewAngle;
                const Camera camera = frameCamera(scene, wanted, {160, 90});
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
        CameraSettings wanted;
        wanted.direction = glm::dvec3{0, -1, 0};
        wanted.viewAngle = viewAngle;
        const Camera camera = frameCamera(scene, wanted, square);
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
    CameraSettings wanted;
    wanted.position = glm::dvec3{3, 4, 5};
    wanted.viewUp = glm::dvec3{1, 2, 0};
    for (const CameraSettings& each : {CameraSettings{}, wanted}) {
        const glm::dmat4 view = frameCamera(skewScene(), each, square).view;
        const glm::dmat3 turn{view};
        EXPECT_NEAR(glm::determinant(turn), 1.0, exact);
        const glm::dmat3 identity = turn * glm::transpose(turn);
        for (int i = 0; i < 3; ++i) expectNear(identity[i], glm::dmat3{1.0}[i]);
        EXPECT_EQ(glm::transpose(view)[3], glm::dvec4(0, 0, 0, 1));
    }
}

TEST(FrameCamera, standsWhereItIsToldAndLooksAtTheFocalPoint) {
    CameraSettings wanted;
    wanted.position = glm::dvec3{10, 2, 7};
    wanted.focalPoint = glm::dvec3{3, 1, -2};
    const Camera camera = frameCamera(skewScene(), wanted, square);
    expectNear(position(camera), {10, 2, 7});
    const glm::dvec3 ndc = scenes::project(camera, square, {3, 1, -2});
    EXPECT_NEAR(ndc.x, 0.0, exact);
    EXPECT_NEAR(ndc.y, 0.0, exact);
    EXPECT_GT(depthOf(camera, {3, 1, -2}), 0.0);
}

TEST(FrameCamera, looksAtTheModelsCentreFromAPositionAlone) {
    const Scene scene = skewScene();
    CameraSettings wanted;
    wanted.position = glm::dvec3{10, 2, 7};
    const Camera camera = frameCamera(scene, wanted, square);
    expectNear(position(camera), {10, 2, 7});
    expectNear(forward(camera), glm::normalize(scene.bounds().centre - glm::dvec3{10, 2, 7}));
}

TEST(FrameCamera, looksAlongADirectionFromAPosition) {
    CameraSettings wanted;
    wanted.position = glm::dvec3{10, 2, 7};
    wanted.direction = glm::dvec3{-2, 0, -2};
    const Camera camera = frameCamera(skewScene(), wanted, square);
    expectNear(position(camera), {10, 2, 7});
    expectNear(forward(camera), glm::dvec3{-1, 0, -1} * std::sqrt(0.5));
}

TEST(FrameCamera, framesAlongADirectionOfAnyLength) {
    for (const double length : {1e-6, 1.0, 1e6}) {
        CameraSettings wanted;
        wanted.direction = length * glm::dvec3{0, -0.6, 0.8};
        const Camera camera = frameCamera(skewScene(), wanted, square);
        expectNear(forward(camera), {0, -0.6, 0.8});
        expectFramed(skewScene(), camera, square);
    }
}

TEST(FrameCamera, centresAFocalPointWithoutAPosition) {
    CameraSettings wanted;
    wanted.focalPoint = glm::dvec3{1, 1, -2};
    const Camera camera = frameCamera(skewScene(), wanted, square);
    const glm::dvec3 ndc = scenes::project(camera, square, {1, 1, -2});
    EXPECT_NEAR(ndc.x, 0.0, exact);
    EXPECT_NEAR(ndc.y, 0.0, exact);
    expectNear(forward(camera), forward(frameCamera(skewScene(), {}, square)));
}

TEST(FrameCamera, turnsTheGivenUpUpwards) {
    CameraSettings wanted;
    wanted.direction = glm::dvec3{0, 0, -1};
    wanted.viewUp = glm::dvec3{5, 5, 3};  // need not be across the view direction, nor of unit length
    const Camera camera = frameCamera(skewScene(), wanted, square);
    expectNear(worldAxis(camera, 1), glm::dvec3{1, 1, 0} * std::sqrt(0.5));
    expectNear(worldAxis(camera, 0), glm::dvec3{1, -1, 0} * std::sqrt(0.5));
    expectFramed(skewScene(), camera, square);
}

TEST(FrameCamera, takesAzimuthFromTheFrontTowardsPlusX) {
    const auto from = [](double azimuth, double elevation) {
        CameraSettings wanted;
        wanted.azimuthAngle = azimuth;
        wanted.elevationAngle = elevation;
        return -forward(frameCamera(skewScene(), wanted, square));
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
    CameraSettings wanted;
    wanted.orthographicHeight = 8.0;
    const Camera camera = frameCamera(skewScene(), wanted, {200, 100});
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
        CameraSettings wanted;
        wanted.orthographicHeight = 0.0;
        const Camera camera = frameCamera(skewScene(), wanted, size);
        ASSERT_TRUE(camera.orthographic());
        expectFramed(skewScene(), camera, size);
        expectVerticesBetweenNearAndFar(skewScene(), camera);
    }
}

TEST(FrameCamera, zoomMagnifiesAboutThePicturesCentre) {
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{0.0}, std::optional{8.0}}) {
        for (const double zoom : {0.25, 3.0}) {
            CameraSettings wanted;
            wanted.orthographicHeight = height;
            const Camera plain = frameCamera(skewScene(), wanted, square);
            wanted.zoomFactor = zoom;
            const Camera zoomed = frameCamera(skewScene(), wanted, square);
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

TEST(FrameCamera, takesTheFilesCamera) {
    CameraSettings wanted;
    wanted.index = 0;
    const Camera ahead = frameCamera(sceneWithCameras(), wanted, square);
    expectNear(position(ahead), {0, 0, 9});
    expectNear(forward(ahead), {0, 0, -1});
    EXPECT_NEAR(ahead.viewAngle, 50.0, exact);
    EXPECT_FALSE(ahead.orthographic());
    expectVerticesBetweenNearAndFar(sceneWithCameras(), ahead);

    wanted.index = 1;
    const Camera side = frameCamera(sceneWithCameras(), wanted, square);
    expectNear(position(side), {7, 0, 0});
    expectNear(forward(side), {-1, 0, 0});
    EXPECT_EQ(side.orthographicHeight, 4.0);
    wanted.zoomFactor = 2.0;
    EXPECT_EQ(frameCamera(sceneWithCameras(), wanted, square).orthographicHeight, 2.0);
}

TEST(FrameCamera, fitsNearAndFarToTheBoundingSphere) {
    const Scene scene = skewScene();
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{0.0}}) {
        CameraSettings wanted;
        wanted.orthographicHeight = height;
        const Camera camera = frameCamera(scene, wanted, square);
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
    CameraSettings wanted;
    wanted.position = scene.bounds().centre + glm::dvec3{0.1, 0, 0};
    wanted.direction = glm::dvec3{1, 0, 0};
    const Camera camera = frameCamera(scene, wanted, square);
    EXPECT_GT(camera.near, 0.0);
    EXPECT_LE(camera.near, 1e-3 * scene.bounds().radius) << "what is close to the camera is not cut off";
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) EXPECT_LT(depthOf(camera, p), camera.far);

    wanted.orthographicHeight = 3.0;
    const Camera flat = frameCamera(scene, wanted, square);
    EXPECT_EQ(flat.near, 0.0) << "an orthographic camera sees from where it stands";
    EXPECT_GT(flat.far, 0.0);
}

TEST(FrameCamera, staysUsableWithEverythingBehindIt) {
    for (const std::optional<double> height : {std::optional<double>{}, std::optional{3.0}}) {
        for (const double distance : {10.0, 1e6}) {
            CameraSettings wanted;
            wanted.position = glm::dvec3{0, 0, distance};
            wanted.direction = glm::dvec3{0, 0, 1};
            wanted.orthographicHeight = height;
            const Camera camera = frameCamera(skewScene(), wanted, square);
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
        CameraSettings wanted;
        wanted.orthographicHeight = height;
        const Camera camera = frameCamera(scenes::sceneOf(point), wanted, square);
        EXPECT_TRUE(std::isfinite(glm::determinant(camera.view)));
        EXPECT_TRUE(std::isfinite(glm::determinant(camera.projection(square))));
        EXPECT_LT(camera.near, camera.far);
    }
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
}  // namespace inkedge::camera
